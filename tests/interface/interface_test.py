#!/usr/bin/env python3
"""The Python module over libplumbline_c: values against C's and against mathematics, refusals, lists without numpy."""
import math
import os
import subprocess
import sys
import unittest

import plumbline


class Interface(unittest.TestCase):
    def test_catalogue(self):
        names = plumbline.solutions()
        self.assertIn("swinging-plate", names)
        amplitude = names["swinging-plate"][0]
        self.assertEqual((amplitude.name, amplitude.unit, amplitude.value), ("amplitude", "m", 0.01))
        laws = plumbline.laws()
        self.assertTrue(math.isnan(next(p for p in laws["j2-logarithmic"] if p.name == "yield").value))

    def test_values(self):  # u_x = A sin(pi X) cos(pi c t), c^2 = (lambda + 2 mu)/rho
        wave = plumbline.Solution("standing-wave", 2, law="linear-elastic", young=1e6, poisson=0, density=1000, amplitude=0.02)
        c, t, x = math.sqrt(1000), 0.01, 0.3
        values = {q: wave.evaluate(q, [[x, 0.5]], t) for q in plumbline.quantities}
        k = math.pi
        self.assertAlmostEqual(values["displacement"][0][0], 0.02 * math.sin(k * x) * math.cos(k * c * t), delta=1e-15)
        self.assertAlmostEqual(values["velocity"][0][0], -0.02 * k * c * math.sin(k * x) * math.sin(k * c * t), delta=1e-13)
        self.assertAlmostEqual(values["F"][0][0][0], 1 + 0.02 * k * math.cos(k * x) * math.cos(k * c * t), delta=1e-14)
        self.assertAlmostEqual(values["P"][0][0][0] / 1e6, 0.02 * k * math.cos(k * x) * math.cos(k * c * t), delta=1e-14)
        self.assertAlmostEqual(values["body_force"][0][0] / 1e6, 0, delta=1e-12)  # an eigenmode of the linear box
        self.assertAlmostEqual(values["static_load"][0][0] / 1e6, 0.02 * k * k * math.sin(k * x) * math.cos(k * c * t),
                               delta=1e-12)
        traction = wave.traction([[x, 0.5]], [[-1, 0]], t)
        self.assertEqual(traction[0][0], -values["P"][0][0][0])
        self.assertEqual(wave.contains([[0.5, 0.5], [1.5, 0.5]]), [True, False])

    def test_judge(self):
        h = [0.4, 0.2, 0.1, 0.05]
        fit = plumbline.fit_order(h, [3 * x**2 for x in h], declared=2)
        self.assertEqual(fit.verdict, "pass")
        self.assertAlmostEqual(fit.order, 2, places=12)
        self.assertAlmostEqual(fit.constant, 3, places=12)
        self.assertEqual(len(fit.pairwise), 3)
        self.assertEqual(plumbline.fit_order(h, [3 * x for x in h], declared=2).verdict, "fail")
        self.assertEqual(plumbline.fit_order(h[:2], h[:2]).verdict, "too-few-levels")
        self.assertTrue(plumbline.meaning("too-few-levels").startswith("Fewer than four"))
        found = plumbline.extrapolate(h[:3], [1 + 3 * x**2 for x in h[:3]])
        self.assertAlmostEqual(found.limit, 1, places=9)
        self.assertAlmostEqual(found.gci[0], 1.25 * (1.12 - 1.03) / 3 / 1.03, places=9)
        grids = plumbline.fit_grids([4, 3, 2, 1.5, 1], [1.118, 1.08, 1.049, 1.032, 1.021])
        self.assertAlmostEqual(grids.uncertainty, 0.0228994832, delta=2e-7)
        norms = plumbline.field_error([[3.0, 4.0], [0.0, 0.0]], None, [0.25, 0.75])
        self.assertEqual((norms.l2, norms.linf, norms.worst), (2.5, 5, 0))

    def test_refusals(self):
        for wrong in (lambda: plumbline.Solution("swinging-plat"), lambda: plumbline.Solution("swinging-plate", 3),
                      lambda: plumbline.Solution("swinging-plate", amplitude=7), lambda: plumbline.Solution("swinging-plate", young=1),
                      lambda: plumbline.Solution("swinging-plate", law="linear-elastic", young=1, poisson=0.5, density=1),
                      lambda: plumbline.Solution("swinging-plate").displacement([[0, 0, 0]], 0),
                      lambda: plumbline.Solution("swinging-plate").displacement([[0, math.nan]], 0),
                      lambda: plumbline.Solution("swinging-plate").traction([[0, 0]], [[1, 1]], 0),
                      lambda: plumbline.Solution("swinging-plate").evaluate("speed", [[0, 0]], 0),
                      lambda: plumbline.Solution("swinging-plate").error("displacement", [[0, 0]], 0, [[math.inf, 0]]),
                      lambda: plumbline.fit_order([1, 1], [1, 2])):
            with self.assertRaises(ValueError):
                wrong()
        with self.assertRaisesRegex(ValueError, 'Did you mean "swinging-plate"'):
            plumbline.Solution("swinging-plat")

    def test_without_numpy(self):
        if os.environ.get("PLUMBLINE_TEST_INNER"):
            self.assertIsNone(plumbline.numpy)
            return
        code = "import sys; sys.modules['numpy'] = None; import unittest, interface_test; unittest.main(interface_test)"
        inner = subprocess.run([sys.executable, "-c", code], env={**os.environ, "PLUMBLINE_TEST_INNER": "1"},
                               cwd=os.path.dirname(os.path.abspath(__file__)), capture_output=True, text=True)
        self.assertEqual(inner.returncode, 0, inner.stderr)


if __name__ == "__main__":
    unittest.main()
