# SPDX-License-Identifier: LGPL-2.1-or-later
"""contrib/effects_cost: rows made of summaries, and that doc/effects.md has a row for every effect of every application (class Document; the environment variable
PELLICLE_BINARIES names the folder of the applications)."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "contrib" / "effects_cost"
sys.path.insert(0, str(FOLDER))
import table
from pairs import PAIRS, Pair, covers

APPLICATIONS = ("vesicle", "droplet_contact", "wetting_ridge", "director_membrane")


def summary(fields, loops, entries, seconds):
    """Loops: (over, points, ((name, kind), ...))."""
    return {
        "unknowns": {"total": sum(fields.values()), **fields},
        "matrix": {"entries": entries},
        "loops": [{"over": over, "points": points, "terms": [{"name": n, "kind": k, "fields": ["position"]} for n, k in terms]} for over, points, terms in loops],
        "seconds per iteration": seconds,
    }


AREA = ("area constraint", "constraint")
PLAIN = summary({"position": 10, "multipliers": 1}, [("surface", 16, (AREA,))], 100, 0.010)
BENT = summary({"position": 10, "moment": 12, "multipliers": 1}, [("surface", 16, (("bending", "energy"), AREA)), ("edge rim", 4, (("bending", "energy"), ("bending", "energy")))], 400, 0.025)


class Rows(unittest.TestCase):
    def test_with_and_without(self):
        pair = Pair("vesicle", "bending", ("area constraint",))
        self.assertEqual(table.row(pair, BENT, PLAIN),
                         ["`vesicle`", "`bending`", "moment (12)", "surface (16 points): 1 energy; edge rim (4 points): 2 energies", "11 -> 23", "100 -> 400", "10 -> 25", "2.50"])

    def test_nothing_added(self):
        cells = table.row(Pair("vesicle", "idle", ()), PLAIN, PLAIN)
        self.assertEqual(cells[2:4], ["none", "none"])
        self.assertEqual(cells[-1], "1.00")

    def test_no_scene_without_it(self):
        cells = table.row(Pair("vesicle", "bending", (), alone=False), BENT, None)
        self.assertEqual(cells[3:], ["surface (16 points): 1 energy; edge rim (4 points): 2 energies", "23", "400", "25", "no scene without it"])

    def test_terms_are_told_by_whole_names(self):
        """'solid' is not 'solid skins', and the terms of a shell are 'shell strain' and 'shell bending'."""
        body = summary({"position": 3}, [("body", 8, (("solid", "energy"),)), ("surface", 2, (("solid skins", "energy"), ("shell strain", "energy")))], 9, 1.0)
        self.assertEqual(table.added_terms("solid", body, None), "body (8 points): 1 energy")
        self.assertEqual(table.added_terms("cosserat shell", body, None), "surface (2 points): 1 energy")

    def test_block_is_renewed(self):
        block = f"{table.BEGIN}\n| `vesicle` | `new` | none |\n{table.END}"
        document = f"before\n{table.BEGIN}\nold\n{table.END}\nafter \\1\n"
        self.assertEqual(table.renewed(document, block), f"before\n{block}\nafter \\1\n")
        self.assertEqual(table.rows_of(table.renewed(document, block)), [("vesicle", "new")])
        for wrong in ("no marks", document + document):
            with self.assertRaises(ValueError):
                table.renewed(wrong, block)

    def test_pairs_differ(self):
        names = [(pair.application, pair.effect) for pair in PAIRS]
        self.assertEqual(len(set(names)), len(names))
        for pair in PAIRS:
            self.assertNotIn(pair.effect, pair.without_it)


class Document(unittest.TestCase):
    def known_effects(self, application):
        """As --write-parameters lists them."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "all.prm"
            subprocess.run([Path(os.environ["PELLICLE_BINARIES"]) / application, "--write-parameters", path], check=True, timeout=60)
            text = path.read_text(encoding="utf-8")
        listed = text.split("# Known: ", 1)[1].split(".\nset Effects", 1)[0].replace("\n#", "")
        return [" ".join(name.split()) for name in listed.split(",")]

    def test_every_effect_has_a_pair_and_a_row(self):
        rows = table.rows_of((ROOT / "doc" / "effects.md").read_text(encoding="utf-8"))
        pairs = [(pair.application, pair.effect) for pair in PAIRS]
        self.assertEqual(rows, pairs, "doc/effects.md: renew the table with contrib/effects_cost/run.py --document doc/effects.md")
        for application in APPLICATIONS:
            effects = self.known_effects(application)
            self.assertGreater(len(effects), 5)
            for effect in effects:
                self.assertTrue(covers(pairs, application, effect), f"contrib/effects_cost/pairs.py has no pair for '{effect}' of {application}")

    def test_run(self):
        """Of one effect, whose numbers follow from its definition: one unknown and a term in the surface's loop."""
        run = subprocess.run([FOLDER / "run.py", "--bin", os.environ["PELLICLE_BINARIES"], "--effects", "gravity", "bilayer coupling", "--repeats", "1"], capture_output=True, text=True,
                             timeout=120, check=False)
        self.assertEqual(run.returncode, 0, run.stderr)
        cells = {line.split(" | ")[1]: line.split(" | ") for line in run.stdout.splitlines() if line.startswith("| `")}
        coupling, gravity = cells["`bilayer coupling`"], cells["`gravity`"]
        self.assertEqual(coupling[2:4], ["none", "surface (384 points): 1 constraint"])
        before, after = map(int, coupling[4].split(" -> "))
        self.assertEqual(after, before + 1)
        entries_before, entries_after = map(int, coupling[5].split(" -> "))
        self.assertLessEqual(entries_after - entries_before, 2 * before + 1)  # one dense row and column
        self.assertGreater(entries_after, entries_before)
        self.assertEqual(gravity[4].split(" -> ")[0], gravity[4].split(" -> ")[1])

    def test_refused_scene_is_a_failure(self):
        run = subprocess.run([FOLDER / "run.py", "--bin", "/nowhere", "--effects", "pressure"], capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(run.returncode, 1)
        self.assertNotIn("Traceback", run.stderr)


if __name__ == "__main__":
    unittest.main()
