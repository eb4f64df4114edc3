/// \file
/// A finished click, box or wish for a menu. It takes effect when the scene to pick in is ready, which takes
/// a moment for a large tree.
#pragma once

#include "core/base/index.h"
#include "core/scene/scene.h"
#include <QObject>
#include <QPointF>
#include <optional>
#include <vector>

namespace ramure {

struct PickHit;
struct ToolContext;

class PendingPick : public QObject
{
    Q_OBJECT
public:
    /// \p context is not owned.
    explicit PendingPick(ToolContext& context)
        : m_context(context)
    {
    }

    /// \param extend adds to the selection, or removes from it
    void click(QPointF at, bool extend);
    void box(QPointF from, QPointF to, bool extend);
    /// Opens the menu of the clicked object and selects it if it was not selected. While everything moves,
    /// opens the menu of the view.
    void menu(QPointF at);
    void forget();
    [[nodiscard]] bool isPending() const { return m_pending.has_value(); }
    /// To be called when the scene to pick in, or the picture, has become ready.
    void tryAgain();

signals:
    /// A click beside everything.
    void missed();
    /// noNode, noIndex where nothing was clicked.
    void menuWanted(QPointF at, ramure::NodeId node, ramure::Index branch);

private:
    struct Pending
    {
        QPointF from, to;
        bool isBox = false;
        bool extend = false;
        bool asksMenu = false;
    };
    void begin(const Pending& pick);
    void tryBox();
    std::vector<Index> takeIntoDocument(PickHit& hit);

    ToolContext& m_context;
    std::optional<Pending> m_pending;
    bool m_boxRuns = false; ///< it is being looked at
};

} // namespace ramure
