/// \file
/// Rows of what stands in the scene: placement, shapes, motion, arms, terrain. Internal to param_table.cpp.
#pragma once

#include "core/params/param_rows.h"

namespace ramure::rows {

// Every text stands in one line per clause; the columns of a table read better than those of the formatter.
// clang-format off
inline constexpr std::array nodeRows{
    row<&NodeParams::tree, &PlacementParams::translation>(
        {"tree.translation", placementGroup, RAMURE_NOOP("Position"),
         RAMURE_NOOP("Position relative to the parent.")},
        ParamUnit::Metre, {-1e6, 1e6, -10, 10, 0.1, 3}, Stage::Placement, paramNone, everyKind),
    row<&NodeParams::tree, &PlacementParams::rotation>(
        {"tree.rotation", placementGroup, RAMURE_NOOP("Rotation"),
         RAMURE_NOOP("How it is turned: first about the parent's X axis, then Y, then Z. Y points up.")},
        ParamUnit::Radian, {-200 * pi, 200 * pi, -pi, pi, pi / 180, 4}, Stage::Placement, paramNone, everyKind),
    row<&NodeParams::tree, &PlacementParams::scale>(
        {"tree.scale", placementGroup, RAMURE_NOOP("Scale"),
         RAMURE_NOOP("How large it is along its own axes; 1 is its natural size.")},
        ParamUnit::Ratio, {1e-4, 1e4, 0.1, 10, 0.1, 3}, Stage::Placement, paramNone, everyKind),

    row<&NodeParams::local, &PlacementParams::translation>(
        {"local.translation", localGroup, RAMURE_NOOP("Own position"),
         RAMURE_NOOP("Moves the node's own shape, but not its children.")},
        ParamUnit::Metre, {-1e6, 1e6, -10, 10, 0.1, 3}, Stage::Placement, paramAdvanced, shapedKinds),
    row<&NodeParams::local, &PlacementParams::rotation>(
        {"local.rotation", localGroup, RAMURE_NOOP("Own rotation"),
         RAMURE_NOOP("Turns the node's own shape, but not its children: first about X, then Y, then Z.")},
        ParamUnit::Radian, {-200 * pi, 200 * pi, -pi, pi, pi / 180, 4}, Stage::Placement, paramAdvanced, shapedKinds),
    row<&NodeParams::local, &PlacementParams::scale>(
        {"local.scale", localGroup, RAMURE_NOOP("Own scale"),
         RAMURE_NOOP("Scales the node's own shape, but not its children.")},
        ParamUnit::Ratio, {1e-4, 1e4, 0.1, 10, 0.1, 3}, Stage::Placement, paramAdvanced, shapedKinds),

    row<&NodeParams::primitive, &PrimitiveParams::shape>(
        {"primitive.shape", primitiveGroup, RAMURE_NOOP("Shape"),
         RAMURE_NOOP("Which solid it is. Cylinders and cones stand on their origin, the others lie about it.")},
        ParamUnit::None, {}, Stage::Mesh, paramNone, primitiveOnly),
    row<&NodeParams::primitive, &PrimitiveParams::radius>(
        {"primitive.radius", primitiveGroup, RAMURE_NOOP("Radius"),
         RAMURE_NOOP("Radius of cylinders, cones and spheres. For a frame cross, the thickness of its arrows.")},
        ParamUnit::Metre, {1e-4, 1e4, 0.01, 5, 0.05, 4}, Stage::Mesh, paramAnimatable, primitiveOnly),
    row<&NodeParams::primitive, &PrimitiveParams::height>(
        {"primitive.height", primitiveGroup, RAMURE_NOOP("Height"),
         RAMURE_NOOP("Length of cylinders and cones along their axis. For a frame cross, the length of its arrows.")},
        ParamUnit::Metre, {1e-4, 1e4, 0.01, 5, 0.05, 4}, Stage::Mesh, paramAnimatable, primitiveOnly),
    row<&NodeParams::primitive, &PrimitiveParams::size>(
        {"primitive.size", primitiveGroup, RAMURE_NOOP("Size"),
         RAMURE_NOOP("Width, height and depth of a box; of a plane the first and the last.")},
        ParamUnit::Metre, {1e-4, 1e4, 0.01, 5, 0.05, 4}, Stage::Mesh, paramAnimatable, primitiveOnly),
    row<&NodeParams::primitive, &PrimitiveParams::sides>(
        {"primitive.sides", primitiveGroup, RAMURE_NOOP("Sides"),
         RAMURE_NOOP("How many sides make a circle. More make it rounder.")},
        ParamUnit::Count, {3, 1024, 3, 64, 1, 0}, Stage::Mesh, paramNone, primitiveOnly),
    row<&NodeParams::primitive, &PrimitiveParams::axis>(
        {"primitive.axis", primitiveGroup, RAMURE_NOOP("Axis"),
         RAMURE_NOOP("Along which of its own axes it stands.")},
        ParamUnit::None, {}, Stage::Mesh, paramNone, primitiveOnly),
    row<&NodeParams::surface, &SurfaceParams::color>(
        {"surface.color", surfaceGroup, RAMURE_NOOP("Colour"),
         RAMURE_NOOP("Red, green and blue of the surface, each from 0 to 1.")},
        ParamUnit::None, {0, 1, 0, 1, 0.01, 3}, Stage::Placement, paramAnimatable | paramColor,
        objectKinds | armOnly | terrainOnly),
    pictureRow<&NodeParams::surfacePictures, &PictureParams::colour>("surface.colourPicture", surfacePicturesGroup, objectKinds),
    pictureRow<&NodeParams::surfacePictures, &PictureParams::normal>("surface.normalPicture", surfacePicturesGroup, objectKinds),
    pictureRow<&NodeParams::surfacePictures, &PictureParams::roughness>("surface.roughnessPicture", surfacePicturesGroup, objectKinds),
    pictureRow<&NodeParams::surfacePictures, &PictureParams::height>("surface.heightPicture", surfacePicturesGroup, objectKinds),
    pictureRow<&NodeParams::surfacePictures, &PictureParams::occlusion>("surface.occlusionPicture", surfacePicturesGroup, objectKinds),
    pictureRow<&NodeParams::surfacePictures, &PictureParams::opacity>("surface.opacityPicture", surfacePicturesGroup, objectKinds),

    row<&NodeParams::growthRole>(
        {"solid.growth", surfaceGroup, RAMURE_NOOP("Trees"),
         RAMURE_NOOP("Role for trees that grow by space colonisation. A tree whose envelope is “Solid” fills the solids below it in the scene; all such trees grow around obstacles. Hidden objects count, too.")},
        ParamUnit::None, {}, Stage::Placement, paramNone, objectKinds),

    row<&NodeParams::physics, &PhysicsParams::mode>(
        {"physics.mode", physicsGroup, RAMURE_NOOP("Mode"),
         RAMURE_NOOP("Robust: damped springs that stay calm for every value. Faithful: the step of the reference, exactly, "
                     "which large values make nervous.")},
        ParamUnit::None, {}, Stage::Motion),
    row<&NodeParams::physics, &PhysicsParams::stepSeconds>(
        {"physics.stepSeconds", physicsGroup, RAMURE_NOOP("Time step"),
         RAMURE_NOOP("How much time passes in each step of the motion. Short steps are more exact and take longer.")},
        ParamUnit::Second, {1e-4, 0.1, 0.002, 0.05, 0.001, 4}, Stage::Motion),
    row<&NodeParams::physics, &PhysicsParams::substeps>(
        {"physics.substeps", physicsGroup, RAMURE_NOOP("Substeps"),
         RAMURE_NOOP("Into how many parts the robust mode divides each step. More follow a quick wind more closely. The "
                     "faithful mode always takes whole steps.")},
        ParamUnit::Count, {1, 64, 1, 8, 1, 0}, Stage::Motion, paramAdvanced),
    row<&NodeParams::physics, &PhysicsParams::gravity>(
        {"physics.gravity", physicsGroup, RAMURE_NOOP("Gravity"),
         RAMURE_NOOP("How heavy everything is: 1 as on Earth, 0 weightless. Apples fall, and branches sag unless the tree starts "
                     "settled.")},
        ParamUnit::Ratio, {0, 100, 0, 3, 0.05, 3}, Stage::Motion, paramAnimatable),
    row<&NodeParams::physics, &PhysicsParams::damping>(
        {"physics.damping", physicsGroup, RAMURE_NOOP("Damping"),
         RAMURE_NOOP("Share of a movement that remains: close to 1 the tree swings for long, at 0 it follows the wind without swinging. Robust: the share after half a swing. Faithful: the share of the speed after each step.")},
        ParamUnit::Ratio, {0, 1, 0, 1, 0.01, 3}, Stage::Motion, paramAnimatable),
    row<&NodeParams::physics, &PhysicsParams::restitution>(
        {"physics.restitution", physicsGroup, RAMURE_NOOP("Stiffness"),
         RAMURE_NOOP("How strongly branches want back to their place. Stiff ones bend less and swing faster.")},
        ParamUnit::None, {0, 1e6, 0, 5000, 10, 1}, Stage::Motion, paramAnimatable),
    row<&NodeParams::physics, &PhysicsParams::restFrame>(
        {"physics.restFrame", physicsGroup, RAMURE_NOOP("Back to"),
         RAMURE_NOOP("The rest position that a branch swings back to: its place relative to its parent, or its first direction in the world. The faithful mode always uses the world.")},
        ParamUnit::None, {}, Stage::Motion, paramAdvanced),
    row<&NodeParams::physics, &PhysicsParams::settled>(
        {"physics.settled", physicsGroup, RAMURE_NOOP("Starts settled"),
         RAMURE_NOOP("The shape as modelled already hangs under its own weight, and motion starts from rest. Off: the weight "
                     "comes on when motion starts, and branches sag. Only in the robust mode.")},
        ParamUnit::None, {}, Stage::Motion),
    row<&NodeParams::physics, &PhysicsParams::appleMass>(
        {"physics.appleMass", physicsGroup, RAMURE_NOOP("Mass of an apple"),
         RAMURE_NOOP("Added to the branch that carries it. A branch itself counts as many kilograms as the radius of its end "
                     "has metres.")},
        ParamUnit::Kilogram, {0, 100, 0, 1, 0.005, 4}, Stage::Motion),
    row<&NodeParams::physics, &PhysicsParams::windStrength>(
        {"physics.windStrength", physicsGroup, RAMURE_NOOP("Wind"),
         RAMURE_NOOP("How strong the wind is, as a factor: 0 is calm, 1 a gentle breeze of 4 m/s on average. The faithful "
                     "mode multiplies the wind of the reference by it.")},
        ParamUnit::Factor, {0, 100, 0, 3, 0.05, 3}, Stage::Motion, paramAnimatable),
    row<&NodeParams::physics, &PhysicsParams::windDirection>(
        {"physics.windDirection", physicsGroup, RAMURE_NOOP("Wind direction"),
         RAMURE_NOOP("Direction that the wind blows to, as a turn about the vertical axis: 0 along X, a quarter turn against Z.")},
        ParamUnit::Radian, {-2 * pi, 2 * pi, -pi, pi, pi / 36, 4}, Stage::Motion, paramAnimatable),
    row<&NodeParams::physics, &PhysicsParams::windGust>(
        {"physics.windGust", physicsGroup, RAMURE_NOOP("Gusts"),
         RAMURE_NOOP("How much the wind swells and dies down within seconds. Only in the robust mode.")},
        ParamUnit::Ratio, {0, 10, 0, 1, 0.05, 3}, Stage::Motion, paramAnimatable),
    row<&NodeParams::physics, &PhysicsParams::windTurbulence>(
        {"physics.windTurbulence", physicsGroup, RAMURE_NOOP("Turbulence"),
         RAMURE_NOOP("How much the wind differs from place to place, quickly, so that twigs flutter. Only in the robust mode.")},
        ParamUnit::Ratio, {0, 10, 0, 1, 0.05, 3}, Stage::Motion, paramAnimatable),
    row<&NodeParams::physics, &PhysicsParams::seed>(
        {"physics.seed", physicsGroup, RAMURE_NOOP("Seed of the wind"),
         RAMURE_NOOP("Another seed gives other gusts and eddies. The same seed always gives the same motion.")},
        ParamUnit::None, {0, maxSeed, 0, 9999, 1, 0}, Stage::Motion, paramSeed),
    row<&NodeParams::physics, &PhysicsParams::appleBounce>(
        {"physics.appleBounce", physicsGroup, RAMURE_NOOP("Apples bounce"),
         RAMURE_NOOP("Share of its speed with which a fallen apple bounces off the ground. At 0 it stays where it falls.")},
        ParamUnit::Ratio, {0, 0.95, 0, 0.95, 0.01, 3}, Stage::Motion),
    row<&NodeParams::physics, &PhysicsParams::appleFriction>(
        {"physics.appleFriction", physicsGroup, RAMURE_NOOP("Apple friction"),
         RAMURE_NOOP("How strongly the ground slows a rolling apple: 0 it rolls on for ever.")},
        ParamUnit::Ratio, {0, 10, 0, 2, 0.05, 3}, Stage::Motion),

    row<&NodeParams::skin, &SkinParams::method>(
        {"skin.method", skinGroup, RAMURE_NOOP("Bends"),
         RAMURE_NOOP("How the bark follows moving branches at forks and bends. Rigid: every ring follows one branch. Linear "
                     "blend: smooth, but strong bends get thin. Dual quaternion: smooth, and branches keep their thickness.")},
        ParamUnit::None, {}, Stage::Motion, paramNone, treeOnly | armOnly),

    row<&NodeParams::arm, &ArmParams::follows>(
        {"arm.follows", armGroup, RAMURE_NOOP("Follows the target"),
         RAMURE_NOOP("Inverse kinematics turns the joints until the tip is at the target. Otherwise the angles stay.")},
        ParamUnit::None, {}, Stage::Motion, paramNone, armOnly),
    row<&NodeParams::arm, &ArmParams::target>(
        {"arm.target", armGroup, RAMURE_NOOP("Target"),
         RAMURE_NOOP("Position that the tip moves to, in the arm's own space: its foot at 0, Z up.")},
        ParamUnit::Metre, {-1e6, 1e6, -5, 5, 0.1, 3}, Stage::Motion, paramAnimatable, armOnly),
    row<&NodeParams::arm, &ArmParams::jointRadius>(
        {"arm.jointRadius", armGroup, RAMURE_NOOP("Joint size"),
         RAMURE_NOOP("Radius of the spheres at the joints.")},
        ParamUnit::Metre, {0, 1e3, 0, 1, 0.01, 3}, Stage::Mesh, paramNone, armOnly),
    row<&NodeParams::ik, &ArmSolverParams::kind>(
        {"ik.solver", ikGroup, RAMURE_NOOP("Solver"),
         RAMURE_NOOP("Damped least squares keeps to the limits and reaches nearly everything in a few steps. Jacobian transpose "
                     "goes downhill in many small ones.")},
        ParamUnit::None, {}, Stage::Motion, paramNone, armOnly),
    row<&NodeParams::ik, &ArmSolverParams::gain>(
        {"ik.gain", ikGroup, RAMURE_NOOP("Step size"),
         RAMURE_NOOP("Jacobian transpose only: how far each step goes. Too much, and the arm shakes.")},
        ParamUnit::None, {1e-5, 10, 0.001, 0.1, 0.001, 5}, Stage::Motion, paramAdvanced, armOnly),
    row<&NodeParams::ik, &ArmSolverParams::stepsPerTick>(
        {"ik.stepsPerTick", ikGroup, RAMURE_NOOP("Steps"),
         RAMURE_NOOP("Jacobian transpose only: steps for each sixtieth of a second.")},
        ParamUnit::Count, {1, 1000, 1, 50, 1, 0}, Stage::Motion, paramAdvanced, armOnly),
    row<&NodeParams::ik, &ArmSolverParams::tolerance>(
        {"ik.tolerance", ikGroup, RAMURE_NOOP("Tolerance"),
         RAMURE_NOOP("Nearer than this, the target counts as reached.")},
        ParamUnit::Metre, {1e-6, 1e3, 1e-5, 0.01, 1e-4, 6}, Stage::Motion, paramAdvanced, armOnly),
    row<&NodeParams::armSkin, &ArmSkinParams::shown>(
        {"armSkin.shown", armSkinGroup, RAMURE_NOOP("Visible"),
         RAMURE_NOOP("Shows the skin; without it, joints and rods.")},
        ParamUnit::None, {}, Stage::Mesh, paramNone, armOnly),
    row<&NodeParams::armSkin, &ArmSkinParams::radius>(
        {"armSkin.radius", armSkinGroup, RAMURE_NOOP("Radius"),
         RAMURE_NOOP("Radius of the cylinder around the arm.")},
        ParamUnit::Metre, {1e-4, 1e3, 0.05, 1, 0.05, 4}, Stage::Mesh, paramNone, armOnly),
    row<&NodeParams::armSkin, &ArmSkinParams::lengthDivisions>(
        {"armSkin.lengthDivisions", armSkinGroup, RAMURE_NOOP("Divisions along"),
         RAMURE_NOOP("Cells of the skin's grid along the arm.")},
        ParamUnit::Count, {1, 4096, 4, 256, 1, 0}, Stage::Mesh, paramNone, armOnly),
    row<&NodeParams::armSkin, &ArmSkinParams::radialDivisions>(
        {"armSkin.radialDivisions", armSkinGroup, RAMURE_NOOP("Divisions around"),
         RAMURE_NOOP("Cells of the skin's grid around the arm.")},
        ParamUnit::Count, {3, 1024, 3, 64, 1, 0}, Stage::Mesh, paramNone, armOnly),
    row<&NodeParams::armSkin, &ArmSkinParams::window>(
        {"armSkin.window", armSkinGroup, RAMURE_NOOP("Blending"),
         RAMURE_NOOP("How far on either side of a joint two segments share the skin; at most half a segment.")},
        ParamUnit::Metre, {0, 1e3, 0, 1, 0.01, 3}, Stage::Mesh, paramNone, armOnly),
    row<&NodeParams::armSkin, &ArmSkinParams::axis>(
        {"armSkin.axis", armSkinGroup, RAMURE_NOOP("Axis of the mesh"),
         RAMURE_NOOP("Which axis of an object comes to lie along the arm when the arm puts it on: Y for a tree.")},
        ParamUnit::None, {}, Stage::Mesh, paramNone, armOnly),
    row<&NodeParams::armSkin, &ArmSkinParams::weights>(
        {"armSkin.weights", armSkinGroup, RAMURE_NOOP("Show weights"),
         RAMURE_NOOP("Colours the skin by the segments that it follows.")},
        ParamUnit::None, {}, Stage::Mesh, paramNone, armOnly),

    row<&NodeParams::terrain, &TerrainParams::seed>(
        {"terrain.seed", terrainGroup, RAMURE_NOOP("Seed of the hills"),
         RAMURE_NOOP("Another seed, another terrain.")},
        ParamUnit::None, {0, maxSeed, 0, 1000, 1, 0}, Stage::Mesh, paramSeed, terrainOnly),
    row<&NodeParams::terrain, &TerrainParams::size>(
        {"terrain.size", terrainGroup, RAMURE_NOOP("Size"),
         RAMURE_NOOP("Length of a side.")},
        ParamUnit::Metre, {1e-3, 1e5, 1, 50, 0.5, 3}, Stage::Mesh, paramAnimatable, terrainOnly),
    row<&NodeParams::terrain, &TerrainParams::height>(
        {"terrain.height", terrainGroup, RAMURE_NOOP("Height"),
         RAMURE_NOOP("How far the widest hills rise and fall.")},
        ParamUnit::Metre, {-1e4, 1e4, 0, 5, 0.1, 3}, Stage::Mesh, paramAnimatable, terrainOnly),
    row<&NodeParams::terrain, &TerrainParams::roughness>(
        {"terrain.roughness", terrainGroup, RAMURE_NOOP("Roughness"),
         RAMURE_NOOP("How high hills of half the width are, compared with the wider ones.")},
        ParamUnit::Ratio, {0, 1, 0, 1, 0.05, 3}, Stage::Mesh, paramAnimatable, terrainOnly),
    row<&NodeParams::terrain, &TerrainParams::divisions>(
        {"terrain.divisions", terrainGroup, RAMURE_NOOP("Divisions"),
         RAMURE_NOOP("Cells of the grid along a side.")},
        ParamUnit::Count, {1, 1024, 8, 256, 1, 0}, Stage::Mesh, paramNone, terrainOnly),
    row<&NodeParams::terrain, &TerrainParams::depth>(
        {"terrain.depth", terrainGroup, RAMURE_NOOP("Depth of the earth"),
         RAMURE_NOOP("How far the block of earth goes down below the lowest place of the ground. 0: a sheet without sides.")},
        ParamUnit::Metre, {0, 1e5, 0, 5, 0.1, 3}, Stage::Mesh, paramAnimatable, terrainOnly),

    row<&NodeParams::camera, &CameraParams::angleRad>(
        {"camera.angle", cameraGroup, RAMURE_NOOP("Angle of view"),
         RAMURE_NOOP("From the top of the picture to its bottom: a wide lens has a large one. 27° is a lens of 50 mm before a "
                     "film of 24 mm.")},
        ParamUnit::Radian, {pi / 180, 150 * pi / 180, pi / 36, pi / 2, pi / 180, 4}, Stage::Placement, paramAnimatable,
        cameraOnly),
    row<&NodeParams::camera, &CameraParams::fStop>(
        {"camera.fStop", cameraGroup, RAMURE_NOOP("F-stop"),
         RAMURE_NOOP("Focal length over the opening of the lens: the smaller, the less is sharp. 0 leaves everything sharp. "
                     "Seen in pictures, and in the view while it looks through the camera and nothing moves.")},
        ParamUnit::None, {0, 128, 0, 16, 0.1, 2}, Stage::Placement, paramAnimatable, cameraOnly),
    row<&NodeParams::camera, &CameraParams::focus>(
        {"camera.focus", cameraGroup, RAMURE_NOOP("Focus"),
         RAMURE_NOOP("Distance at which the lens is in focus.")},
        ParamUnit::Metre, {0.001, 1e4, 0.1, 30, 0.1, 3}, Stage::Placement, paramAnimatable, cameraOnly),
};
// clang-format on

} // namespace ramure::rows
