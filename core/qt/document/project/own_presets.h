/// \file
/// Trees that the user has saved as presets: each a project file of one tree in a folder, with a picture of
/// the same name beside it. Shared presets are copied there.
#pragma once

#include "core/scene/scene.h"
#include <QString>
#include <QStringList>

namespace ramure {

class OwnPresets
{
public:
    /// How an own preset is told from one that ships with the program: "own:" before its name.
    static constexpr const char* mark = "own:";
    static constexpr int longestName = 80; ///< characters

    /// QStandardPaths::AppDataLocation/presets.
    OwnPresets();
    /// \param folder is made when the first preset is saved.
    explicit OwnPresets(QString folder);

    [[nodiscard]] const QString& folder() const { return m_folder; }
    /// In the order of the alphabet.
    [[nodiscard]] QStringList names() const;
    [[nodiscard]] QString pictureFile(const QString& name) const;
    /// Returns this name, with a number behind it if it is taken.
    [[nodiscard]] QString freeName(const QString& wanted) const;

    /// Returns the file's first tree, without an id. Errors: those of loadProjectFile; Invalid (no tree in
    /// it).
    [[nodiscard]] Expected<Node> load(const QString& name) const;
    /// Saves the parameters of the tree and the edits of its branches, without its place and its keys.
    /// Errors: Invalid (a name that no file can have, or taken), those of saveProjectFile.
    Expected<void> save(const QString& name, const Node& tree) const;
    /// Errors: Invalid (a name that no file can have, or taken), Io.
    Expected<void> rename(const QString& name, const QString& other) const;
    /// Moves it to the desktop's trash. Error: Io.
    Expected<void> remove(const QString& name) const;

private:
    [[nodiscard]] QString file(const QString& name) const;
    [[nodiscard]] Expected<void> checkFree(const QString& name) const;

    QString m_folder;
};

/// Returns the tree with this name: "own:NAME" or the name of a preset that ships. Errors: those of
/// OwnPresets::load or of presetTree.
Expected<Node> namedTree(const QString& preset);

} // namespace ramure
