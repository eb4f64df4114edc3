"""Steps of a recipe as objects."""
import unittest

import ramure


class TestSteps(unittest.TestCase):
    def setUp(self):
        self.tree = ramure.grow("TinyTree", seed=3)
        self.before = self.tree.validate()["hash"]

    def names(self):
        return [step.name for step in self.tree.steps]

    def test_read_set_add_remove_move(self):
        steps = self.tree.steps
        self.assertEqual(self.names(), ["grammar"])
        sag = steps.add("sag", {"sag.amount": 0.5})
        gnarl = steps.add("gnarl", {"gnarl.angle": 0.2}, name="Twigs")
        flare = steps.add("flare", place=1)
        self.assertEqual(self.names(), ["grammar", "flare", "sag", "Twigs"])
        self.assertEqual((sag["sag.amount"], gnarl["gnarl.angle"], gnarl.kind), (0.5, 0.2, "gnarl"))
        sag["sag.amount"] = 2
        self.assertEqual((sag["sag.amount"], self.tree["sag.amount"]), (2.0, 2.0))
        sag.move(3)
        self.assertEqual(self.names(), ["grammar", "flare", "Twigs", "sag"])
        self.assertEqual(sag["sag.amount"], 2.0, "a step is the same one wherever it is")
        gnarl.name = "Knots"
        self.assertEqual(steps["Knots"], gnarl)
        self.assertEqual(len({sag, gnarl, steps["sag"], steps[2]}), 2)
        changed = self.tree.validate()["hash"]
        self.assertNotEqual(changed, self.before)
        gnarl.enabled = False
        self.assertFalse(steps["Knots"].enabled)
        self.assertEqual(gnarl.state, "off")
        self.assertNotEqual(self.tree.validate()["hash"], changed)
        for step in (sag, gnarl, flare):
            step.remove()
        self.assertEqual(self.tree.validate()["hash"], self.before, "nothing is left of them")

    def test_two_of_one_kind(self):
        one, other = self.tree.steps.add("sag"), self.tree.steps.add("sag", {"sag.amount": 3.0})
        self.assertNotEqual(one, other)
        self.assertEqual((one["sag.amount"], other["sag.amount"]), (1.0, 3.0))
        with self.assertRaises(ramure.Error):
            self.tree["sag.amount"]
        self.assertEqual(self.tree["#3.sag.amount"], 3.0)

    def test_every_kind_that_can_be_added(self):
        for kind in ramure.step_kinds():
            self.assertTrue(kind["label"])
            if kind["group"] == "hand" or not kind["parameters"]:
                continue
            with self.subTest(kind["kind"]):
                step = self.tree.steps.add(kind["kind"])
                self.assertEqual((step.kind, step.keys()), (kind["kind"], kind["parameters"]))
                for key in step.keys():
                    step[key] = step[key]
                self.assertEqual(step.data["op"], kind["kind"])
                step.remove()

    def test_what_hands_do(self):
        axes = self.tree.axes()
        limb = int(axes.address[axes.order == 1][0])
        self.tree.edit({"op": "cut", "target": f"{limb:016x}", "at": 0.4, "name": "Sawn"},
                       {"op": "thickness", "target": f"{limb:016x}", "factor": 1.5})
        sawn = self.tree.steps["Sawn"]
        self.assertEqual((sawn.kind, sawn.state, sawn.data["at"]), ("cut", "placed", 0.4))
        self.assertEqual(len(self.tree.steps), 3)
        self.tree["grammar.seed"] = 4
        self.assertIn(sawn.state, ("placed", "matched", "unplaced"))

    def test_source(self):
        source = ramure.grow("SilverBirch", seed=1, age=3).steps[0]
        self.assertEqual((source.kind, source.state, source.why, source["growth.age"]), ("growth", "placed", "", 3.0))
        source["growth.age"] = 4
        self.assertEqual(source.data["values"]["growth.age"], 4.0)


if __name__ == "__main__":
    unittest.main()
