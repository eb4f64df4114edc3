/// \file
/// The formats that the program reads and writes besides its projects, as one table. File dialogs, drag and
/// drop, the export dialog and the command line ask it. A new format is a file beside obj_format.cpp and a
/// row of file_formats.cpp.
#pragma once

#include "core/io/export_scene.h"

namespace ramure {

struct BlenderImport;
struct ImportOptions;

/// What a format can hold. Options for anything else are not offered.
enum FormatHolds : std::uint16_t {
    holdsObjects = 1, ///< objects by name, each with its material; else all is one mesh
    holdsTexture = 2,
    holdsSpace = 4,        ///< any axes and unit
    holdsLines = 8,        ///< a skeleton as line segments
    holdsCopies = 16,      ///< leaves and fruit as instances
    holdsClip = 32,        ///< a sequence of frames as one file that moves
    holdsLevels = 64,      ///< levels of detail; else each is a file
    holdsCompressed = 128, ///< numbers made small: WriteOptions::compressed
    holdsVariants = 512,   ///< seasons of leaves: ExportMesh::seasons
    holdsRiders = 1024,    ///< instances that go with the bones of a clip
    holdsShapes = 2048,    ///< forms of a mesh between which it moves: ExportMesh::shapes
    holdsWind = 256,       ///< data by which shaders of games move vertices: ExportMesh::wind
};

/// Bytes of a vertex and of a triangle, about.
struct FileRates
{
    double vertex = 0.0, triangle = 0.0;
};

struct FileFormat
{
    const char* id = "";     ///< "ply-text": its name in tests and dialogs
    const char* ending = ""; ///< "ply", lower case; formats that share one stand together
    const char* name = "";   ///< in lists of file formats, as text to translate
    const char* choice = ""; ///< in the list of the export dialog, as text to translate
    const char* help = "";   ///< in the help of `ramure-cli export`, behind the ending
    std::uint16_t holds = 0; ///< bits of FormatHolds
    bool isText = false; ///< if two formats share an ending, WriteOptions::ascii picks the one with isText
    const char* beside = ""; ///< the ending of a second file with the materials
    /// All as meshes; null: nothing can be read so. \see readMeshFile
    Expected<ReadMesh> (*read)(const std::string& path, const Progress& progress) = nullptr;
    /// Reads the file as nodes of a scene. \see importObjects
    Expected<BlenderImport> (*import)(const std::string& path, const ImportOptions& options,
                                      const Progress& progress) = nullptr;
    /// Writes the parts of the scene that the format can hold.
    Expected<void> (*write)(const std::string& path, const ExportScene& scene, const WriteOptions& options,
                            const Progress& progress) = nullptr;
    /// Returns the bytes written per element if vertex numbers have so many digits.
    FileRates (*rates)(bool texture, double digits) = nullptr;
};

/// The table, in the order of the dialogs.
std::span<const FileFormat* const> fileFormats();

enum class FormatUse : std::uint8_t { Read, Import, Write };
bool isFor(const FileFormat& format, FormatUse use);
/// Finds a format by the ending of the path. If two formats share the ending, \p asText decides. Error:
/// Unknown, with all known endings.
Expected<const FileFormat*> findFormat(const std::string& path, FormatUse use, bool asText = false);
/// "tree.OBJ": "obj".
std::string endingOf(const std::string& path);
/// Each ending once: ".obj, .ply".
std::string endingList(FormatUse use, const char* before = ".", const char* between = ", ");

} // namespace ramure
