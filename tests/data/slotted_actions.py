"""Run by plain Python: the export script on stand-ins for what Blender 4.4 and later have, actions with slots.

python3 slotted_actions.py ramure_export.py
"""

import importlib.util
import sys
import types


class Thing:
    """Anything with these attributes."""

    def __init__(self, **members):
        self.__dict__.update(members)


class Anything(Thing):
    """Takes every call and has every attribute: what the script only needs to be there when it is loaded."""

    def __init__(self, *args, **members):
        super().__init__(**members)

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return type(name, (Anything,), {})

    def __call__(self, *args, **members):
        return Anything()


def module(name, **members):
    made = types.ModuleType(name)
    made.__dict__.update(members)
    sys.modules[name] = made
    return made


def curve(path, axis, mute=False):
    return Thing(data_path=path, array_index=axis, mute=mute, keyframe_points=[])


class LaterAction(Thing):
    """Without the curves of old: asking for them is an AttributeError."""


def names(found):
    return sorted(found)


def check(condition, text):
    if not condition:
        sys.exit("slotted actions: " + text)


types_of = Thing(Operator=type("Operator", (), {}), TOPBAR_MT_file_export=Anything())
props = module("bpy.props", **{n: (lambda **_: None) for n in ("StringProperty", "BoolProperty", "IntProperty")})
module("bpy", types=types_of, props=props, utils=Anything(), app=Anything(background=True), context=Anything())
module("mathutils", Matrix=Anything, Quaternion=Anything, Vector=Anything)
extras = module("bpy_extras")
extras.io_utils = module("bpy_extras.io_utils", ExportHelper=type("ExportHelper", (), {}))

spec = importlib.util.spec_from_file_location("ramure_export", sys.argv[1])
script = importlib.util.module_from_spec(spec)
spec.loader.exec_module(script)

mine, other = Thing(name="mine"), Thing(name="other")
bags = {id(mine): Thing(fcurves=[curve("location", 0), curve("location", 1, mute=True), curve("scale", 2)]),
        id(other): Thing(fcurves=[curve("rotation_quaternion", 0)])}


def object_with(action, slot, **more):
    members = dict(nla_tracks=[], drivers=[], action=action, action_slot=slot)
    members.update(more)
    return Thing(animation_data=Thing(**members))


# 4.4: a layered action, whose old list of curves is that of its first slot; no function to ask for another's.
strip = Thing(channelbag=lambda slot: bags.get(id(slot)))
layered = Thing(is_action_layered=True, fcurves=bags[id(other)].fcurves, layers=[Thing(strips=[strip])])
for helped in (False, True):
    if helped:  # 4.5 and later
        extras.anim_utils = module("bpy_extras.anim_utils",
                                   action_get_channelbag_for_slot=lambda action, slot: bags.get(id(slot)))
        layered = LaterAction(is_action_layered=True, layers=[])
    check(names(script.curves_of(object_with(layered, mine))) == [("location", 0), ("scale", 2)], "the curves of its slot")
    check(names(script.curves_of(object_with(layered, other))) == [("rotation_quaternion", 0)], "of another slot")
    check(script.curves_of(object_with(layered, Thing(name="empty"))) == {}, "a slot without curves")
    check(script.curves_of(object_with(layered, None)) == {}, "no slot")

# Before 4.4, and actions of old files.
old = Thing(fcurves=[curve("location", 2)])
check(names(script.curves_of(object_with(old, None))) == [("location", 2)], "an action of old")
check(script.curves_of(object_with(None, None)) == {}, "no action")
check(script.curves_of(Thing(animation_data=None)) == {}, "no animation")
check(script.curves_of(object_with(old, None, nla_tracks=[Thing(mute=False)])) is None, "NLA")
check(script.curves_of(object_with(old, None, drivers=[Thing()])) is None, "drivers")
print("slotted actions: well")
