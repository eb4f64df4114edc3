/// \file
/// A finished click, box or wish for a menu: it takes effect when what is picked in is ready, which a large
/// tree takes a moment for.
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

    /// \param extend adds to what is selected, or takes away
    void click(QPointF at, bool extend);
    void box(QPointF from, QPointF to, bool extend);
    /// Of what is clicked, which becomes selected where it is not yet; while everything moves, of the view.
    void menu(QPointF at);
    void forget();
    [[nodiscard]] bool isPending() const { return m_pending.has_value(); }
    /// After what is picked in, or what is shown, has become ready.
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
