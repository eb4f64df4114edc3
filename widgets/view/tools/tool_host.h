/// \file
/// What tools ask of the view that they work in. The viewport is one; tests have another, without OpenGL.
#pragma once

#include "core/params/tree_edit.h"
#include "widgets/base/theme/navigation_style.h"
#include "widgets/view/render/pick/pick_scene.h"
#include <QPointF>
#include <QString>
#include <chrono>
#include <functional>

namespace ramure {

struct TreeResult;

class ToolHost
{
public:
    /// The camera, and the size of the picture in logical pixels.
    [[nodiscard]] virtual PickView view() const = 0;
    /// As the hand moves it: at once.
    virtual void setCamera(const Camera& camera) = 0;
    virtual void stopFlight() = 0; ///< of the camera, where it is on its way
    virtual void flyToSide(AxisView side) = 0;
    [[nodiscard]] virtual NavigationStyle navigationStyle() const = 0;
    [[nodiscard]] virtual bool isWindVisible() const = 0;

    /// What is drawn: everything in its place of now.
    [[nodiscard]] virtual const RenderScene& shownScene() const = 0;
    /// The same before anything is moved.
    [[nodiscard]] virtual const RenderScene& sceneAtRest() const = 0;
    /// Something else than the document of now is shown.
    [[nodiscard]] virtual bool isStale() const = 0;
    /// The tree as the last picture shows it, which may be a draft, or older than the document. Null: the
    /// picture has no such tree.
    [[nodiscard]] virtual const TreeResult* shownTree(NodeId node) const = 0;
    /// To pick in what is shown: its branches are those of shownTree(). It may be waited for so long; null
    /// where it is not made by then.
    [[nodiscard]] virtual std::shared_ptr<const PickScene> pickScene(std::chrono::milliseconds patience) = 0;
    /// Returns the structure to pick in of a moment ago; null before the first.
    [[nodiscard]] virtual std::shared_ptr<const PickScene> latestPickScene() const = 0;
    /// Everything between two corners; \p done is called later, unless another box comes first. False where
    /// there is nothing to pick in.
    virtual bool pickBox(QPointF cornerA, QPointF cornerB,
                         std::function<void(const std::vector<PickedBranches>&)> done) = 0;
    /// Lets go of something large where that does not hold up the interface.
    virtual void dispose(std::shared_ptr<const void> last) = 0;

    /// Shows these branches of the tree as those that would change, until noNode is given.
    /// \param go they would be taken away
    virtual void markBranches(NodeId node, std::vector<Index> branches, bool go) = 0;
    void unmarkBranches() { markBranches(noNode, {}, false); }

    /// Where the leaves of the view, or its fruit, are hidden, they are shown again.
    virtual void showOrgans(EditOrgan kind) = 0;
    virtual void repaint() = 0;
    virtual void updateHint() = 0;
    /// What the hand wanted and could not have, and why.
    virtual void raiseMessage(const QString& text) = 0;

protected:
    ~ToolHost() = default;
};

} // namespace ramure
