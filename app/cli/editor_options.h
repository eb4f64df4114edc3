/// \file
/// The options of the editor. Its command line, its manual page and the completion of the shell follow from
/// them.
#pragma once

namespace ramure {

struct EditorOption
{
    const char* name;  ///< without dashes
    const char* value; ///< "FILE", empty for a switch
    const char* description;
};

inline constexpr EditorOption screenshotOption = {
    "screenshot", "FILE.png", "Write a picture of the window when the tree is there, and quit."};
inline constexpr EditorOption exportOption = {"export", "FILE",
                                              "Write the tree as a mesh file, and quit. May repeat."};
inline constexpr EditorOption sizeOption = {"size", "WxH", "Size of the window."};
inline constexpr EditorOption editorOptions[] = {screenshotOption, exportOption, sizeOption};

inline constexpr const char* editorSummary = "Editor for trees. Without arguments it opens the SmallTree.";
inline constexpr const char* editorInput = "[FILE|FOLDER|preset:NAME|demo:NAME]";
inline constexpr const char* editorInputText =
    "A file .ramure, %1, a folder of objects from Blender, preset:NAME or demo:NAME.";

} // namespace ramure
