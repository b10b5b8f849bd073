"""Mistakes in the command itself."""

import json
import pathlib
import re

from making import changed_json, config, copy, file, log
from mistake import MALAGA, TREE, Mistake

LOCALIZE = "localize {configs}/malaga.jsonld {malaga}/malaga-demo.log.gz --map {malaga}/malaga-demo.map.yaml -o out"


def run_of_the_corridor(bench):
    bench.opal(*(word.format(configs=TREE / "configs", malaga=MALAGA) for word in LOCALIZE.split()))


def tracked_drive(bench):
    bench.opal("track", "malaga", str(MALAGA / "malaga-demo.log.gz"), "--map", str(MALAGA / "malaga-demo.map.yaml"),
               "--truth", str(MALAGA / "malaga-demo.gt.csv"), "-o", "out")


def runs_of_two_logs(bench):
    run_of_the_corridor(bench)
    log(lambda it: it.lines.__delitem__(slice(40, None)))(bench)
    bench.opal("localize", str(TREE / "configs" / "malaga.jsonld"), "wrong.log", "--map",
               str(MALAGA / "malaga-demo.map.yaml"), "-o", "other")


def arms_with_usual_plugins(bench):
    """An experiment whose second arm has the program's own folder of plugins; of one query of the corridor."""
    plugins = str(pathlib.Path(bench.program).resolve().parents[1] / "plugins")
    queries = json.loads((MALAGA / "malaga-demo.queries.json").read_text())["queries"]
    bench.write("twice.jsonld", json.dumps({
        "@context": "urn:opal:v1", "@type": "opal:Experiment", "metrics": ["success"],
        "arms": [{"name": "usual"}, {"name": "twice", "plugins": [plugins]}],
        "sites": [{"prefix": str(MALAGA / "malaga-demo"), "queries": [queries[0]["id"]]}]}))


def experiment(change):
    """An experiment of two arms on the corridor, changed."""

    def make(bench):
        document = {"@context": "urn:opal:v1", "@type": "opal:Experiment", "arms": [{"name": "a"}, {"name": "b"}],
                    "sites": [{"prefix": str(MALAGA / "malaga-demo")}]}
        change(document)
        bench.write("wrong.jsonld", json.dumps(document))

    return make


def old_plugin(bench):
    """A plugin of the tree that says that it was built for plugin API 0."""
    plugins = pathlib.Path(bench.program).resolve().parents[1] / "plugins"
    bench.write("here/corners.so", re.sub(rb"opal_v\d", b"opal_v0", (plugins / "corners.so").read_bytes()))
    bench.write("here/corners.jsonld", (plugins / "corners.jsonld").read_bytes())


MISTAKES = [
    Mistake("no command", "No command is given.", "", 2, ["A subcommand is required", "--help"]),
    Mistake("unknown command", "The command does not exist.", "locate", 2,
            ["'locate': no command of opal, expected one of: demo, map, info, localize"]),
    Mistake("nothing to read", "`opal localize` without its configuration and log.", "localize", 2,
            ["opal localize: CONFIG is required", "Usage: opal localize [OPTIONS] CONFIG LOG"]),
    Mistake("unknown option", "An option is misspelled.", LOCALIZE + " --quieries x.json", 2,
            ["opal localize: --quieries: no option of this command, did you mean --queries?",
             "Usage: opal localize [OPTIONS] CONFIG LOG"]),
    Mistake("building that is not in the experiment", "A building of an experiment is misspelled.",
            "experiment buildings -o out --building corridor-75-99", 3,
            ["experiment: none is called 'corridor-75-99', expected some of corridor-75-1, corridor-75-2", "more"],
            absent=["out"]),
    Mistake("number of nothing", "An experiment is asked for no runs.", "experiment thesis3 -o out --seeds 0", 2,
            ["--seeds: 0 is not in range, expected a number above 0"], absent=["out"]),
    Mistake("run of another command", "`opal calibration` gets a folder that `opal track` has written.",
            "calibration out", 3, ["out/summary.json: /site: missing, expected a folder that opal bench wrote"],
            make=tracked_drive),
    Mistake("too many words", "A word stands where the command expects no more.", "explain out at 7", 2,
            ["opal explain: not expected: at, 7"]),
    Mistake("map that is not named", "`opal serve` is not told of a map.", "serve {configs}/default.jsonld", 3,
            ["default.jsonld: /map: missing; name a map here or with --map"]),
    Mistake("word instead of a number", "A word stands where a number is expected.",
            "simulate {maps}/gemini.jsonld -o sim --fov wide", 2,
            ["--fov: 'wide', expected a number from 1 to 360"]),
    Mistake("value out of its range", "A number makes no sense.", "simulate {maps}/gemini.jsonld -o sim --beams 0", 2,
            ["--beams", "0", "1 to 100000"]),
    *[Mistake(f"simulation with {option} {value}", wrong, f"simulate {{maps}}/gemini.jsonld -o sim {option}={value}", 2,
              [option, f"{value} is not in range, expected"], absent=["sim.log.gz"])
      for option, value, wrong in [
          ("--drives", "0", "No drive is asked for."),
          ("--distance", "-5", "A drive has a negative length."),
          ("--speed", "-1", "The robot shall drive backwards."),
          ("--scan-every", "0", "Scans have no time between them."),
          ("--range", "0", "The laser sees nothing."),
          ("--doors-open", "70", "A share is given in percent."),
          ("--people", "5000", "More people are asked for than the building has room for."),
      ]],
    Mistake("swapped arguments", "Log and configuration are swapped.",
            "localize {malaga}/malaga-demo.log.gz {configs}/malaga.jsonld -o out", 3,
            ["malaga-demo.log.gz", "expected JSON text"], absent=["out"]),
    Mistake("start pose of two numbers", "`--pose` has no heading.",
            "track {configs}/malaga.jsonld {malaga}/malaga.log.gz --pose 0,0 -o out", 3,
            ["--pose: '0,0'", "expected X,Y,THETA in metres and radians"], absent=["out"]),
    Mistake("start pose in degrees", "The heading of `--pose` is in degrees.",
            "track {configs}/malaga.jsonld {malaga}/malaga.log.gz --pose 0,0,90 -o out", 3,
            ["--pose: heading 90, expected radians from -2 pi to 2 pi; 90 degrees are 1.571"], absent=["out"]),
    Mistake("no start pose", "`opal track` is not told where the robot starts.",
            "track {configs}/malaga.jsonld {malaga}/malaga.log.gz -o out", 3,
            ["no start pose", "--pose X,Y,THETA or --truth"], absent=["out"]),
    Mistake("map in place of the configuration", "Configuration and map are swapped.",
            "localize {maps}/example_room.jsonld {malaga}/malaga-demo.log.gz --map {configs}/malaga.jsonld -o out", 3,
            ["example_room.jsonld: is a map, expected a deployment document; a map is named behind --map"], absent=["out"]),
    Mistake("file that is no run", "`opal explain` gets a file in place of the folder.", "explain {configs}/malaga.jsonld", 3,
            ["malaga.jsonld:1: ", "expected a folder that 'opal localize' wrote"]),
    Mistake("moment that is no time", "`--at` is a word.", "explain out --at soon", 3,
            ["moment 'soon'", "expected seconds since the start"],
            make=run_of_the_corridor),
    Mistake("moment after the end", "`--at` is later than the run.", "explain out --at 1000", 3,
            ["moment 1000.000 s, expected one in [0.000, 9.283]"],
            make=run_of_the_corridor),
    Mistake("query that the run does not have", "`--query` is misspelled.", "explain out --query q77", 3,
            ["time line 'q77' was asked for, the run has: run"], make=run_of_the_corridor),
    Mistake("folder of no run", "`opal view` gets a folder that `opal localize` has not written.", "view here", 3,
            ["here/events.jsonl: does not exist", "opal localize"], make=file("here/readme.txt", "nothing\n")),
    Mistake("runs of two logs", "`opal view` gets runs of two logs.", "view out other", 0,
            ["the runs are of two logs, malaga-demo.log.gz and wrong.log", "expected runs of one log"],
            make=runs_of_two_logs),
    Mistake("no run of a benchmark", "`opal calibration` gets a folder that `opal bench` has not written.",
            "calibration out -o calibration", 3, ["out/summary.json: does not exist", "opal bench"],
            make=run_of_the_corridor, absent=["calibration"]),
    Mistake("prefix with its ending", "`opal bench` gets a file instead of a prefix.",
            "bench {malaga}/malaga-demo.log.gz -o out", 3,
            ["malaga-demo.log.gz.map.yaml do not exist, expected the prefix of a recorded place"], absent=["out"]),
    Mistake("goal in a wall", "`opal drive` has to go where no room is.",
            "drive {configs}/default.jsonld {maps}/gemini.jsonld --goal 500,500 -o out", 3,
            ["--goal", "it lies beyond the building", "expected a place on the green floor of"]),
    Mistake("configuration with an unknown key", "A key of the configuration is misspelled.",
            "localize config.jsonld {malaga}/malaga-demo.log.gz -o out", 3, ["config.jsonld: /scorer: unknown key, expected one of: ", "scorers"],
            make=config(lambda document: document.update({"scorer": []})), absent=["out"]),
    Mistake("configuration whose only scorers are misspelled", "The key of the only scorers is misspelled.",
            "localize config.jsonld {malaga}/malaga-demo.log.gz -o out", 3,
            ['config.jsonld: /scorer: unknown key, did you mean "scorers"?'],
            make=config(lambda document: document.update({"scorer": document.pop("scorers")})), absent=["out"]),
    Mistake("experiment with a misspelled key", "A key that an experiment needs is misspelled.", "ab wrong.jsonld -o out", 3,
            ['wrong.jsonld: /site: unknown key, did you mean "sites"?'],
            make=experiment(lambda document: document.update({"site": document.pop("sites")})), absent=["out"]),
    Mistake("experiment with a misspelled place", "A recorded place of an experiment is misspelled.",
            "ab wrong.jsonld -o out", 3,
            ["wrong.jsonld: /sites/0/prefix: ", "malaga-dmo", "expected the prefix of a recorded place",
             "malaga-dmo.queries.json does not exist"],
            make=experiment(lambda document: document["sites"][0].update({"prefix": "malaga-dmo"})), absent=["out"]),
    Mistake("configuration with a wrong type", "A number of the configuration is a text.",
            "localize config.jsonld {malaga}/malaga-demo.log.gz -o out", 3,
            ["config.jsonld", "/sensor/beams", '"361"', "integer"],
            make=config(lambda document: document["sensor"].update({"beams": "361"})), absent=["out"]),
    Mistake("part that is not installed", "The configuration names a plugin that is not there.",
            "localize config.jsonld {malaga}/malaga-demo.log.gz -o out", 3,
            ["config.jsonld: /scorers/0/@type: \"opal:Beems\", which no plugin offers", "opal:Beams"],
            make=config(lambda document: document.update({"scorers": [{"@type": "opal:Beems"}]})), absent=["out"]),
    Mistake("scorer twice", "A scorer is in the list twice, to count double.",
            "localize config.jsonld {malaga}/malaga-demo.log.gz -o out", 3,
            ["config.jsonld: /scorers/1/@type: \"opal:Beams\"", "its evidence would count twice"],
            make=config(lambda document: document.update({"scorers": 2 * [{"@type": "opal:Beams"}]})), absent=["out"]),
    Mistake("scorer without weight", "The only scorer has the weight 0.",
            "localize config.jsonld {malaga}/malaga-demo.log.gz -o out", 3,
            ["config.jsonld: /scorers: no scorer decides", "a weight above 0"],
            make=config(lambda document: document.update({"scorers": [{"@type": "opal:Beams", "weight": 0}]})),
            absent=["out"]),
    Mistake("template that is not installed", "`opal map patterns` is told of a template that is not there.",
            "map patterns {maps}/gemini.jsonld --template opal:ColumPair -o patterns.jsonld", 3,
            ["no plugin offers opal:ColumPair", "opal:ColumnPair"], absent=["patterns.jsonld"]),
    Mistake("name where a file may stand", "`opal calibrate` gets the name of a configuration that ships: no mistake.",
            "calibrate malaga {malaga}/malaga-demo.log.gz", 0, ["mount heading [deg]"]),
    Mistake("plugins of an arm twice", "An arm of an experiment names a folder of plugins that is loaded anyway: no mistake.",
            "ab twice.jsonld -o out", 0, ["2 of 2 cells are finished"], make=arms_with_usual_plugins),
    Mistake("configuration without a map", "The map is named nowhere.",
            "localize {configs}/default.jsonld {malaga}/malaga-demo.log.gz -o out", 3,
            ["default.jsonld: /map: missing", "--map"], absent=["out"]),
    Mistake("old plugin", "A plugin was built for another version of Opal.", "plugins here", 1,
            ["here/corners.so", "was built for plugin API 0, this is"], make=old_plugin),
    Mistake("old plugin in use", "A folder of plugins has one that was built for another version of Opal.", LOCALIZE, 0,
            ["plugin refused: ./here/corners.so: was built for plugin API 0", "at the end: localized"], make=old_plugin,
            environment={"OPAL_PLUGIN_PATH": "{here}/here"}),
    Mistake("file that is no plugin", "Some other file lies in a folder of plugins.", "plugins here", 1,
            ["here/old.so", "truncated"], make=file("here/old.so", b"\x7fELF old")),
]
