"""The completion of bash for the program: completion.py PROGRAM FILE

The words are those that the program lists. Where it takes a file, bash completes files.
"""

import pathlib
import sys

import program_help

SCRIPT = """# bash completion for opal; made of what `opal COMMAND --help` lists
_opal() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} place=opal k
  local -A commands=(
{commands}  )
  local -A options=(
{options}  )
  for ((k = 1; k < COMP_CWORD; ++k)); do
    [[ " ${{commands[$place]-}} " != *" ${{COMP_WORDS[k]}} "* ]] || place+=" ${{COMP_WORDS[k]}}"
  done
  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "${{options[$place]}}" -- "$word"))
  else
    COMPREPLY=($(compgen -W "${{commands[$place]-}}" -- "$word"))
  fi
}}
complete -o bashdefault -o default -F _opal opal
"""


def table(lines):
    return "".join(f'    ["{place}"]="{" ".join(words)}"\n' for place, words in lines)


def main():
    places = [(" ".join(["opal", *c.words]), c) for c in program_help.read_program(sys.argv[1]).walk()]
    text = SCRIPT.format(commands=table((place, [b.words[-1] for b in c.commands]) for place, c in places if c.commands),
                         options=table((place, c.options()) for place, c in places))
    file = pathlib.Path(sys.argv[2])
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)
    print(f"completion of {len(places)} commands in {file}")


main()
