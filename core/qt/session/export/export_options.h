/// \file
/// Options of an export: which parts of a scene are exported, and how they are written.
#pragma once

#include "core/game_wind/wind_profile.h"
#include "core/io/file_space.h"
#include "core/io/mesh_file.h"
#include "core/lod/level_options.h"
#include "core/print/print_options.h"
#include "core/scene/scene.h"
#include <vector>

namespace ramure {

enum class ExportModel : std::uint8_t {
    Mesh,     ///< the one continuous mesh, triangle leaves, round apples
    Rough,    ///< SPEC A3: open cylinders, square leaves, cubes
    Skeleton, ///< one line segment per branch of the simplified skeleton; parts do not matter
};

enum ExportPart : std::uint8_t { exportBranches = 1, exportLeaves = 2, exportApples = 4, exportAll = 7 };

/// Names by which an engine knows what bodies bump into.
enum class CollisionNames : std::uint8_t {
    None,   ///< there is nothing
    Unreal, ///< UCX_, the name of the mesh, a number
    Godot,  ///< the name of the mesh, a number, -convcolonly
    Unity,  ///< COL_, the name of the mesh, a number
};

/// Engines that get a folder of their own (engine_folder.h).
enum class Engine : std::uint8_t { None, Godot, Unity, Unreal };

struct ExportOptions
{
    ExportModel model = ExportModel::Mesh;
    std::uint8_t parts = exportAll; ///< bits of ExportPart
    std::vector<NodeId> nodes;      ///< these and the trees below them; empty = the whole scene
    bool hidden = false;            ///< also nodes that are not shown
    bool instances = false;         ///< leaves and apples as a list beside the file (core/io/copy_list.h)
    bool copies = false;            ///< copies of a scatter stay copies; else all of a prototype are one mesh
    bool texture = false;     ///< trees with texture coordinates; the rough model and the skeleton have none
    std::vector<double> clip; ///< s, further times: trees and arms of ExportModel::Mesh then have skins
    LevelOptions levels;      ///< levels of trees, see ExportModel::Mesh
    bool levelFiles = false;  ///< each level is a file also where the format holds them all
    CollisionNames collision = CollisionNames::None; ///< of trees of ExportModel::Mesh
    Engine engine = Engine::None; ///< the path is a folder, or a .zip of one, for this engine
    bool variants = false;        ///< leaves and fruit in four seasons
    double growthFrom = 0.0;      ///< years: trees grow as one mesh from this age on; 0: they have their age
    double growthSpeed = 5.0;     ///< years a second
    int growthKeys = 12;          ///< most key shapes of it
    std::int64_t growthTriangles = 60'000;
    WindProfile wind = WindProfile::None; ///< data of trees by which games move them
    WriteOptions write;
    FileSpace space;    ///< the axes and the unit of the file
    PrintOptions print; ///< options of printScene()
};

} // namespace ramure
