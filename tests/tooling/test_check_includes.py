# SPDX-License-Identifier: LGPL-2.1-or-later
"""contrib/utilities/check_includes.py on tiny trees, each with one known breach."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "contrib" / "utilities"))
import check_includes


class CheckIncludes(unittest.TestCase):
    def breaches(self, files):
        """Runs the checker on a tree with these files (path -> text)."""
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                path = Path(folder) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return list(check_includes.breaches(folder))

    def test_left_is_allowed(self):
        self.assertEqual(
            self.breaches(
                {
                    "include/pellicle/base/a.h": "#include <vector>\n",
                    "include/pellicle/kinematics/b.h": "#include <pellicle/base/a.h>\n",
                    "source/assembly/c.cc": "#include <pellicle/kinematics/b.h>\n#include <deal.II/grid/tria.h>\n",
                }
            ),
            [],
        )

    def test_right_is_forbidden_in_headers_and_sources(self):
        found = self.breaches(
            {
                "include/pellicle/assembly/right.h": "",
                "include/pellicle/potentials/left.h": "#pragma once\n\n#include <pellicle/assembly/right.h>\n",
                "source/discretization/left.cc": "#include <pellicle/assembly/right.h>\n",
            }
        )
        self.assertEqual(len(found), 2)
        self.assertTrue(found[0].startswith("include/pellicle/potentials/left.h:3: 'potentials' must not include 'assembly'"))
        self.assertTrue(found[1].startswith("source/discretization/left.cc:1: 'discretization' must not include 'assembly'"))

    def test_point_rooms_know_no_mesh(self):
        for room in ("base", "kinematics", "potentials"):
            for header in ("deal.II/grid/tria.h", "mpi.h"):
                found = self.breaches({f"source/{room}/x.cc": f"# include <{header}>\n"})
                self.assertEqual(len(found), 1, room)
                self.assertIn(f"must not include <{header}>", found[0])

    def test_scene_readers_may_use_deal_ii(self):
        text = "#include <deal.II/base/parameter_handler.h>\n"
        self.assertEqual(self.breaches({"source/base/scene.cc": text, "include/pellicle/base/expression.h": text}), [])

    def test_deal_ii_through_an_own_header(self):
        found = self.breaches(
            {
                "include/pellicle/base/scene_file.h": "#include <deal.II/base/parameter_handler.h>\n",
                "include/pellicle/base/between.h": "#include <pellicle/base/scene_file.h>\n",
                "source/potentials/x.cc": "#include <pellicle/base/between.h>\n",
            }
        )
        self.assertEqual(len(found), 2)
        self.assertIn("base/between.h:1", found[0])
        self.assertIn(
            "source/potentials/x.cc:1: 'potentials' knows no mesh and no MPI, but this leads there: "
            "pellicle/base/between.h -> pellicle/base/scene_file.h -> deal.II/base/parameter_handler.h",
            found[1],
        )

    def test_no_way_round(self):
        found = self.breaches(
            {
                "source/base/x.cc": '#include "../assembly/y.h"\n#include <pellicle/elsewhere/y.h>\n#include <pellicle/base/lost.h>\n'
            }
        )
        self.assertEqual(len(found), 3)
        self.assertIn("instead of", found[0])
        self.assertIn("no room 'elsewhere'", found[1])
        self.assertIn("does not exist", found[2])

    def test_private_header_beside_the_file(self):
        self.assertEqual(self.breaches({"source/solvers/x.cc": '#include "private.h"\n', "source/solvers/private.h": ""}), [])


if __name__ == "__main__":
    unittest.main()
