"""Render scenes in every technique and quality and print what each costs, as a Markdown table.

usage: python3 RenderCost.py PROGRAM FOLDER [SIZE]

PROGRAM is `meso`, FOLDER holds the scenes, SIZE is WIDTHxHEIGHT (default 512x512). The numbers are
those of `meso render --stats`. Times are noise on a shared machine: compare the column `x plain`,
the ratio to technique `plain` of the same scene, rather than milliseconds.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

# `plain` looks up no map, so its quality makes no difference.
QUALITIES = ("draft", "low", "medium", "high")
SETTINGS = [("plain", "medium")]
SETTINGS += [(technique, q) for technique in ("relief", "tessellated") for q in QUALITIES]
# Said of a scene that a setting is too fine for: a row of the table, but no failure of the run.
TOO_FINE = "more than the limit"
HEADER = ("scene", "technique", "quality", "GPU ms", "x plain", "frame ms", "fetches mean", "max")


def stats(program, scene, technique, quality, size):
    """What `--stats` says, or the reason why there is none."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "stats.json")
        command = [program, "render", str(scene), "-o", f"{folder}/picture.png", "--size", size]
        command += ["--technique", technique, "--quality", quality, "--stats", str(file)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            return None, (done.stderr.strip().splitlines() or ["no message"])[-1]
        return json.loads(file.read_text(encoding="utf-8")), ""


def rows(program, scene, size):
    """One row a setting; a setting that fails is a row as well, with its reason."""
    plain = None
    for technique, quality in SETTINGS:
        found, reason = stats(program, scene, technique, quality, size)
        if found is None:
            yield (scene.stem, technique, quality, f"failed: {reason}", "", "", "", ""), None
            continue
        gpu = found["gpu_ms"]["median"]
        plain = gpu if technique == "plain" else plain
        ratio = f"{gpu / plain:.2f}" if plain else ""
        row = (scene.stem, technique, quality, f"{gpu:.2f}", ratio)
        row += (f"{found['frame_ms']['median']:.2f}", f"{found['fetches_mean']:.1f}")
        yield row + (f"{found['fetches_max']:g}",), found


def main(arguments):
    if len(arguments) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 2
    program, folder = arguments[:2]
    size = arguments[2] if len(arguments) == 3 else "512x512"
    scenes = sorted(pathlib.Path(folder).glob("*.json"))
    if not scenes:
        print(f"{folder}: no scene", file=sys.stderr)
        return 1
    device, failed = None, False
    for scene in scenes:
        for row, found in rows(program, scene, size):
            if found is None:
                failed = failed or TOO_FINE not in row[3]
            elif device is None:
                device = found["device"]
                print(f"meso {found['version']}, {size}, {device}\n")
                print("| " + " | ".join(HEADER) + " |\n|" + " --- |" * len(HEADER))
            print("| " + " | ".join(row) + " |", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
