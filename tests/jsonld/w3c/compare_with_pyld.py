"""Maps and example documents give the same graph through Opal's JSON-LD processor and through PyLD.

usage: compare_with_pyld.py SOURCE_DIR JSON_LD_TOOL OPAL
Exit codes: 0 the same, 1 not, 77 PyLD is not installed (skipped).
"""
import glob
import json
import os
import subprocess
import sys
import tempfile

try:
    from pyld import jsonld
except ImportError:
    print("skipped: PyLD is not installed (python3-pyld)")
    sys.exit(77)

BASE = "http://opal.example/"
FRAMES = {
    "segments with what they stand for": {
        "@context": ["urn:opal:v1", {"represents": {"@reverse": "opal:represented_by"}}],
        "@type": "LineSegment", "represents": {}},
    "walls": {"@context": "urn:opal:v1", "@type": "Wall", "represented_by": {"@explicit": True, "represented_by": {}}},
    "names alone": {"@context": "urn:opal:v1", "@type": "Wall", "@explicit": True},
    "no match": {"@context": "urn:opal:v1", "@type": "Window"},
    "properties": {"@context": "urn:opal:v1", "x": {}, "@embed": "@never"},
    "value": {"@context": "urn:opal:v1", "radius_m": {"@default": 1}, "center": {"@embed": "@never"}, "@requireAll": True},
}


def tool_output(*command):
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def canonical(document, options):
    return jsonld.normalize(document, {**options, "algorithm": "URDNA2015", "format": "application/n-quads"})


def sorted_arrays(value):
    if isinstance(value, dict):
        return {key: sorted_arrays(entry) for key, entry in value.items() if not str(entry).startswith("_:")}
    if isinstance(value, list):
        return sorted((sorted_arrays(entry) for entry in value), key=lambda entry: json.dumps(entry, sort_keys=True))
    return value


def main():
    source, tool, opal = sys.argv[1:]
    with open(f"{source}/maps/context/opal.jsonld") as file:
        context = json.load(file)

    def load(url, _options):
        if url != "urn:opal:v1":
            raise ValueError(f"{url} is not fetched")
        return {"contextUrl": None, "documentUrl": url, "document": context, "contentType": "application/ld+json"}

    options = {"base": BASE, "documentLoader": load}
    differing = 0
    with tempfile.TemporaryDirectory() as folder:
        hall = f"{folder}/malaga.jsonld"
        subprocess.run([opal, "map", "import", f"{source}/maps/malaga/malaga-demo.map.yaml", "-o", hall], check=True,
                       stdout=subprocess.DEVNULL)
        maps = sorted(glob.glob(f"{source}/maps/*.jsonld")) + [hall]
        others = [path for pattern in ("maps/context/*.jsonld", "maps/overlays/*.jsonld", "configs/*.jsonld",
                                       "plugins/*/plugin.jsonld", "patterns/*/plugin.jsonld")
                  for path in sorted(glob.glob(f"{source}/{pattern}"))]
        for path in maps + others:
            with open(path) as file:
                document = json.load(file)
            same = canonical(document, options) == canonical(tool_output(tool, BASE, path), options)
            differing += not same
            print("same graph" if same else "ANOTHER GRAPH", os.path.relpath(path, source))
        for path in maps:
            with open(path) as file:
                document = json.load(file)
            for name, frame in FRAMES.items():
                with open(f"{folder}/frame.jsonld", "w") as file:
                    json.dump(frame, file)
                ours = tool_output(tool, BASE, path, f"{folder}/frame.jsonld")
                theirs = jsonld.frame(document, frame, options)
                same = sorted_arrays(ours) == sorted_arrays(theirs)
                differing += not same
                print("same answer" if same else "ANOTHER ANSWER", os.path.relpath(path, source), "to", name)
                if not same:
                    print(json.dumps(sorted_arrays(ours))[:1500])
                    print(json.dumps(sorted_arrays(theirs))[:1500])
    return 1 if differing else 0


sys.exit(main())
