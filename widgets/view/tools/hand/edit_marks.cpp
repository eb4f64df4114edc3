// While a tree is shaped, limbs that a hand has changed carry a mark.
#include "core/evaluate/evaluator.h"
#include "widgets/view/tools/hand/edit_tool.h"
#include "widgets/view/tools/tool_table.h"
#include <QPainter>
#include <algorithm>

namespace ramure {
namespace {

class EditMarks : public Tool
{
public:
    using Tool::Tool;

    bool press(const ToolPoint&) override { return false; }
    void documentChanged(const Change&) override { m_stale = true; }
    void sceneReady() override { m_stale = true; }
    void paint(QPainter& painter, const PickView& view) override;

private:
    void look();

    bool m_stale = true;
    glm::dmat4 m_world{1.0};
    std::vector<glm::dvec3> m_places; ///< tree space
};

/// Of a limb that was cut the end, of others the foot.
void EditMarks::look()
{
    m_stale = false;
    m_places.clear();
    const Document& document = m_context.document;
    const NodeId tree = treeMeant(document);
    const Node* node = document.scene().find(tree);
    const TreeResult* shown = m_context.limbs.tree(document, tree);
    if (!node || !document.scene().isShown(tree) || !shown || !shown->edits)
        return;
    m_world = EvaluatedScene(document.scene()).transforms(tree).geometry;
    const Skeleton& skeleton = shown->simplified->skeleton;
    for (const EditOutcome& outcome : *shown->edits) {
        const auto edit = std::ranges::find(node->params.edits, outcome.id, &TreeEdit::id);
        const bool acts = outcome.state == EditState::ByAddress || outcome.state == EditState::ByLikeness;
        if (edit == node->params.edits.end() || !acts)
            continue;
        const bool drawn = edit->operation == EditOperation::Draw;
        const auto limb = m_context.limbs.limb(document, tree, drawn ? outcome.id : outcome.address);
        if (!limb.empty())
            m_places.push_back(edit->operation == EditOperation::Cut
                                   ? skeleton.p1[limb.back()]
                                   : 0.5 * (skeleton.p0[limb.front()] + skeleton.p1[limb.front()]));
    }
}

void EditMarks::paint(QPainter& painter, const PickView& view)
{
    if (m_context.hand.tool() == HandTool::None || m_context.isPlaying())
        return;
    if (m_stale)
        look();
    constexpr double reach = 4.5;
    painter.setPen(QPen(QColor(16, 22, 28, 200), 1.4));
    painter.setBrush(QColor(255, 190, 60));
    for (const glm::dvec3& place : m_places)
        if (const auto at = view.pixel(glm::dvec3(m_world * glm::dvec4(place, 1.0)))) {
            const QPointF here(at->x, at->y);
            painter.drawPolygon(QPolygonF({here + QPointF(0.0, -reach), here + QPointF(reach, 0.0),
                                           here + QPointF(0.0, reach), here + QPointF(-reach, 0.0)}));
        }
}

} // namespace

std::unique_ptr<Tool> makeEditMarks(ToolContext& context)
{
    return std::make_unique<EditMarks>(context);
}

} // namespace ramure
