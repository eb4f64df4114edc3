/// \file
/// Trees that other programs describe by their numbers: Arbaro (arbaro_format.cpp), ez-tree
/// (ez_tree_format.cpp). They become trees of Weber and Penn. Internal to the formats.
#pragma once

#include "core/io/formats/text/blender_scene.h"
#include "core/params/node_params.h"
#include <optional>
#include <string_view>

namespace ramure {

/// The whole text of a file of parameters. Errors: Io, Limit (over 4 MiB), Invalid (\p options ask for axes:
/// such files have none).
Expected<std::string> readSheet(const std::string& path, const ImportOptions& options);

/// Collects what a file says of a tree.
class TreeSheet
{
public:
    explicit TreeSheet(std::string file);

    NodeParams
        params; ///< at first a tree as the presets of species have it, with the paper's aspen's numbers

    /// Sets the place in the file from which the next values and notes come.
    void standAt(std::string_view path, int line = 0);
    void note(const char* text, std::vector<std::string> args = {});
    [[nodiscard]] tl::unexpected<Error> refuse(ErrorCode code, const char* text,
                                               std::vector<std::string> args = {}) const;
    /// \param key a number or a choice by its number. Error: Invalid, outside the parameter's range.
    Expected<void> set(std::string_view key, double value);
    /// The nearest value that a parameter can have, where the file's lies outside its range; that is noted.
    /// \param factor from the unit of the file to that of the program
    /// \param matters false: it has no effect on this tree, and needs no note
    /// Error: Invalid (not finite, or not whole where the parameter is).
    Expected<void> fit(std::string_view key, double value, double factor = 1.0, bool matters = true);
    /// Leaves and bark of the species with this name, whatever its spelling, or else of a plant whose name is
    /// part of it: "quaking_aspen", "ca_black_oak". What was taken is noted.
    void dressAs(std::string_view species);
    /// Twigs of the last level carry leaves, so many each.
    /// \param length m, of a leaf; none: as the plant has them
    Expected<void> setLeaves(double perStem, std::optional<double> length);
    /// One tree.
    BlenderImport finish(std::string name) &&;

private:
    [[nodiscard]] Error placed(Error error) const;

    std::string m_file, m_path;
    int m_line = 0;
    std::vector<Note> m_notes;
};

} // namespace ramure
