"""What a tree was grown from, kept on the object that holds it and saved with the file."""
import bpy

from . import program


def _names(_self, _context, typed):
    try:
        return [one["name"] for one in program.species() if typed.lower() in one["name"].lower()]
    except program.Problem:
        return []


class RamureTree(bpy.types.PropertyGroup):
    is_tree: bpy.props.BoolProperty(options={"HIDDEN"})
    species: bpy.props.StringProperty(
        name="Species", default="EnglishOak", search=_names,
        description="A tree that ships with Ramure, or the path of a .ramure file")
    seed: bpy.props.IntProperty(name="Seed", default=1, min=0, description="Another seed is another tree of its kind")
    age: bpy.props.FloatProperty(
        name="Age", default=0.0, min=0.0, max=2000.0,
        description="Years, of a species that grows by years; 0: the age of the species")
    day: bpy.props.IntProperty(
        name="Day of the year", default=0, min=0, max=365, description="Leaves and flowers of that day; 0: summer")
    triangles: bpy.props.IntProperty(
        name="Triangles of the bark", default=0, min=0, max=20_000_000, step=1000,
        description="0: as many as the species has")
    leaves: bpy.props.EnumProperty(
        name="Leaves", default="INSTANCES", items=[
            ("INSTANCES", "Instances", "Each leaf is an instance of one mesh: light files, and leaves that can be exchanged"),
            ("MERGED", "One mesh", "All leaves are one mesh"),
            ("NONE", "None", "The bare tree")])
    levels: bpy.props.StringProperty(
        name="Levels", default="", description="Budgets of levels of detail, such as 40000,10000,2500: a collection "
        "each. Empty: the tree alone. Leaves are one mesh then")
    wind: bpy.props.FloatProperty(
        name="Wind loop", default=0.0, min=0.0, max=60.0, unit="TIME", description="Seconds of a loop of wind, as an "
        "armature with its action; 0: the tree is at rest. Leaves are one mesh then")
    pictures: bpy.props.EnumProperty(
        name="Pictures", default="1024", items=[(n, n, "Pixels a side of bark and leaves") for n in
                                                ("0", "256", "512", "1024", "2048", "4096")])
    more: bpy.props.StringProperty(
        name="Parameters", default="", description="Further parameters as KEY=VALUE, separated by semicolons; "
        "`ramure-cli list params` shows the keys")
    grown: bpy.props.StringProperty(options={"HIDDEN"})  # hash of the tree as it was grown last

    def words(self):
        """What ramure-cli is asked."""
        is_file = "." in self.species or "/" in self.species
        words = [bpy.path.abspath(self.species) if is_file else "preset:" + self.species,
                 "--map-size", self.pictures]
        sets = {"grammar.seed": self.seed}
        if self.age > 0.0:
            sets["growth.age"] = round(self.age, 3)
        if self.day > 0:
            sets["season.day"] = self.day
        if self.triangles > 0:
            sets["mesh.targetTriangles"] = self.triangles
        for key, value in sets.items():
            words += ["--set", f"{key}={value}"]
        for pair in filter(None, (pair.strip() for pair in self.more.split(";"))):
            words += ["--set", pair]
        if self.levels.strip():
            words += ["--budget", self.levels.replace(" ", "")]
        if self.wind > 0.0:
            words += ["--wind-loop", str(round(self.wind, 3)), "--joints", "256"]
        if self.leaves == "NONE":
            words += ["--part", "branches"]
        elif self.leaves == "INSTANCES" and not self.levels.strip() and self.wind == 0.0:
            words += ["--leaves", "instances"]
        return words


def register():
    bpy.utils.register_class(RamureTree)
    bpy.types.Object.ramure = bpy.props.PointerProperty(type=RamureTree)
    bpy.types.WindowManager.ramure_state = bpy.props.StringProperty(options={"SKIP_SAVE"})


def unregister():
    del bpy.types.WindowManager.ramure_state
    del bpy.types.Object.ramure
    bpy.utils.unregister_class(RamureTree)
