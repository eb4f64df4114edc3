/// \file
/// Makes the levels of detail of one tree of a document in the background, as an export would write them, and
/// again when the tree has changed: to be looked at before anything is exported. They are no part of the
/// document.
#pragma once

#include "core/lod/level_switches.h"
#include "core/math/box.h"
#include "core/qt/document/document.h"
#include <QObject>
#include <functional>
#include <memory>

namespace ramure {

/// The levels of a tree, with their figures.
struct TreeLevels
{
    NodeParams params; ///< the tree's parameters
    TreeResult whole;  ///< the tree that they were made of, at rest, with its leaves
    std::vector<TreeLevel> levels;
    LevelSwitches switches; ///< distances in the scene, with the node's scale
    Box box;                ///< m, of the whole tree, in its own space
    double scale = 1.0;     ///< scale of the node: metres of the scene per metre of the tree

    /// Which one is shown at a distance, m in the scene.
    [[nodiscard]] std::size_t levelAt(double distance) const;
};

class LevelWatch : public QObject
{
    Q_OBJECT
public:
    enum class State {
        None,    ///< no tree to look at
        Growing, ///< the tree itself is still being computed
        Waiting, ///< for a short rest after the last change
        Running,
        Done,
        Cancelled, ///< until start(), or until tree or options are others
        Failed,    ///< see error(): the tree, or the options
    };
    /// treeLevels(), or what tests take in its place.
    using Function = std::function<Expected<std::vector<TreeLevel>>(
        const TreeResult& tree, const NodeParams& params, const LevelOptions& options,
        const Progress& progress)>;

    /// \param document must outlive this object.
    explicit LevelWatch(Document* document, QObject* parent = nullptr);
    LevelWatch(Document* document, Function function, QObject* parent = nullptr); ///< for tests
    ~LevelWatch() override; ///< stops what runs; waits at most Job::patience

    /// Nothing is computed while inactive; inactive at first.
    void setActive(bool on);
    /// If only the switches differ, the new switches are reported at once.
    void setOptions(const LevelOptions& options);
    [[nodiscard]] const LevelOptions& options() const;
    /// Returns the active node if it is a tree, else the tree whose branches are selected, else the first
    /// selected tree. If nothing is selected, returns the only tree of the scene. Else noNode.
    [[nodiscard]] NodeId tree() const;
    [[nodiscard]] State state() const;
    /// Keeps the earlier levels while others are being made. Null before the first, and after a failure.
    [[nodiscard]] std::shared_ptr<const TreeLevels> levels() const;
    /// The reason of State::Failed: an error of treeLevels(), or why there is no tree.
    [[nodiscard]] const Error& error() const;
    /// How long a change rests before it is looked at, default 300 ms.
    void setRest(int milliseconds);

public slots:
    void cancel();
    void start(); ///< after a cancel, and for those who do not want to wait for the rest

signals:
    void changed(); ///< tree, state or levels
    void progress(double fraction);

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace ramure
