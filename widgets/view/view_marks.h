/// \file
/// What panels and tools point at in a view: a section, a tree's isolated branches, and branches that are
/// shown as if the mouse were over them.
#pragma once

#include "core/scene/scene.h"
#include "widgets/view/render/scene_builder.h"
#include <QObject>
#include <vector>

namespace ramure {

class ViewMarks : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;

    /// Forgets what belongs to another document. What is isolated follows its own signal.
    void beginDocument();
    /// A tool marks the branches that it would change, until noNode or no branch is given.
    /// \param go it would take them away
    void mark(NodeId node, std::vector<Index> branches, bool go);
    /// Adds the marks to \p view, whose hoverNode is what the mouse is over; \p scene is what it shows.
    void addTo(SceneView& view, const Scene& scene) const;

public slots:
    /// Shows the section's plane, circle and frame, until noNode is given.
    void inspect(ramure::NodeId node, ramure::Index branch, ramure::Index section);
    /// Shows only these branches of the tree, until noNode or no branch is given.
    void isolate(ramure::NodeId node, const std::vector<ramure::Index>& branches);
    /// Shows them as if the mouse were over them, until noNode is given: for a row that it is over elsewhere.
    void pointAt(ramure::NodeId node, const std::vector<ramure::Index>& branches);

signals:
    void sceneChanged();      ///< another scene is to be made
    void highlightsChanged(); ///< the same scene has other highlights

private:
    /// Branches of one node; noNode: nothing.
    struct Branches
    {
        NodeId node = noNode;
        std::vector<Index> branches;
        bool go = false; ///< they would be taken away
        bool operator==(const Branches&) const = default;
    };
    InspectedSection m_inspected;
    Branches m_isolated;
    Branches m_pointed; ///< by a row of the scene panel
    Branches m_marked;  ///< by a tool
};

} // namespace ramure
