"""Arrays share the memory of the library, cannot be written, and outlive the tree."""
import gc
import unittest

import numpy
import ramure


class Arrays(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tree = ramure.grow("SilverBirch", seed=2, age=6)

    def arrays_of(self, thing):
        return {name: value for name, value in vars(thing).items() if isinstance(value, numpy.ndarray)}

    def test_two_looks_share_one_memory(self):
        first, second = self.tree.mesh(), self.tree.mesh()
        for name, array in self.arrays_of(first).items():
            self.assertTrue(numpy.shares_memory(array, getattr(second, name)), name)
        bones = self.tree.skeleton()
        self.assertTrue(numpy.shares_memory(bones.start, self.tree.skeleton().start))

    def test_nothing_can_be_written(self):
        for thing in (self.tree.mesh(texture=True), self.tree.skeleton(), self.tree.axes(), self.tree.leaves()):
            for name, array in self.arrays_of(thing).items():
                self.assertFalse(array.flags.writeable, name)
                self.assertFalse(array.flags.owndata, name)
                with self.assertRaises(ValueError):
                    array[...] = 0
                with self.assertRaises(ValueError):
                    array.setflags(write=True)

    def test_they_outlive_the_tree(self):
        tree = ramure.grow("TinyTree", seed=4)
        things = [tree.mesh(), tree.skeleton(), tree.axes(), tree.leaves()]
        before = [{name: array.copy() for name, array in self.arrays_of(thing).items()} for thing in things]
        tree["grammar.seed"] = 5
        tree.grow().close()
        del tree
        gc.collect()
        for seed in range(3):  # what was freed would be written over
            ramure.grow("TinyTree", seed=seed).mesh()
        for thing, copies in zip(things, before):
            for name, array in self.arrays_of(thing).items():
                numpy.testing.assert_array_equal(array, copies[name], name)

    def test_one_column_outlives_the_others(self):
        column = ramure.grow("TinyTree", seed=4).mesh().positions[::2, 1]
        gc.collect()
        ramure.grow("TinyTree", seed=8)
        self.assertTrue(numpy.isfinite(column).all())

    def test_mesh(self):
        mesh = self.tree.mesh()
        found = self.tree.validate()
        self.assertEqual((len(mesh.positions), len(mesh.triangles)), (found["vertices"], found["faces"]))
        self.assertEqual((mesh.positions.dtype, mesh.triangles.dtype), (numpy.float32, numpy.uint32))
        self.assertLess(mesh.triangles.max(), len(mesh.positions))
        edges = numpy.sort(mesh.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        _, counts = numpy.unique(edges, axis=0, return_counts=True)
        self.assertTrue((counts == 2).all(), "each edge has two triangles")
        a, b, c = (mesh.positions[mesh.triangles[:, i]].astype(float) for i in range(3))
        self.assertAlmostEqual(numpy.einsum("ij,ij->i", a, numpy.cross(b, c)).sum() / 6, found["volume"], places=6)
        numpy.testing.assert_allclose(numpy.linalg.norm(mesh.normals, axis=1), 1.0, atol=1e-4)
        self.assertIsNone(mesh.uv)
        worn = self.tree.mesh(texture=True)
        self.assertEqual(worn.triangles.shape, worn.uv_triangles.shape)
        self.assertLess(worn.uv_triangles.max(), len(worn.uv))

    def test_levels(self):
        meshes = self.tree.meshes(levels=3, budget=[9000, 3000, 1000])
        self.assertEqual(sorted({mesh.lod for mesh in meshes}), [0, 1, 2])
        self.assertEqual([mesh.name for mesh in meshes if mesh.lod == 0], ["branches_LOD0", "leaves_LOD0"])

    def test_leaves(self):
        leaves = self.tree.leaves()
        self.assertEqual(leaves.matrices.shape, (len(leaves), 4, 4))
        merged = next(mesh for mesh in self.tree.meshes(part="leaves") if mesh.name == "leaves")
        self.assertEqual(len(merged.triangles), len(leaves) * len(leaves.shape.triangles))
        placed = numpy.einsum("nij,pj->npi", leaves.matrices[:, :3, :3], leaves.shape.positions) + \
            leaves.matrices[:, None, :3, 3]
        numpy.testing.assert_allclose(placed.reshape(-1, 3), merged.positions, atol=1e-4)
        self.assertTrue((leaves.matrices[:, 3] == (0, 0, 0, 1)).all())
        self.assertTrue((leaves.branch >= 0).all())

    def test_a_tree_without_leaves_or_fruit(self):
        bare = ramure.grow("DeadSnag")
        self.assertIsNone(bare.fruit())
        self.assertIsNone(bare.leaves())
        self.assertGreater(len(bare.mesh().triangles), 100)

    def test_skeleton_and_axes(self):
        bones, axes = self.tree.skeleton(), self.tree.axes()
        self.assertEqual(bones.parent[0], -1)
        rows = numpy.arange(len(bones))
        self.assertTrue((bones.parent < rows).all())
        children = bones.parent >= 0
        numpy.testing.assert_allclose(bones.start[children], bones.end[bones.parent[children]], atol=1e-9)
        info = self.tree.info(axes=True)
        self.assertEqual(len(bones), info["branches"])
        self.assertAlmostEqual(numpy.linalg.norm(bones.end - bones.start, axis=1).sum(), info["totalLength"], places=6)
        self.assertEqual([f"{address:016x}" for address in axes.address], [axis["id"] for axis in info["axes"]])
        numpy.testing.assert_allclose(axes.length, [axis["length"] for axis in info["axes"]], atol=1e-12)
        self.assertEqual(sorted(axes.branches.tolist()), rows.tolist())
        for axis in (0, 1, len(axes) - 1):
            own = axes.branches[axes.first[axis]:axes.first[axis] + axes.count[axis]]
            self.assertTrue((axes.axis_of_branch[own] == axis).all())
        self.assertLessEqual(len(self.tree.skeleton(simplified=True)), len(bones))


if __name__ == "__main__":
    unittest.main()
