#include "widgets/window/problem_button.h"

#include "core/params/param_def.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/icons.h"

namespace ramure {

ProblemButton::ProblemButton(Document* document, QWidget* parent)
    : QToolButton(parent)
    , m_document(document)
{
    setObjectName(QStringLiteral("problemButton"));
    setAutoRaise(true);
    setIcon(ramure::icon("error"));
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    setFocusPolicy(Qt::TabFocus);
    connect(m_document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeResults | changeReset | changeStructure | changeSelection | changeParams |
                       changeBranches))
            update();
    });
    connect(this, &QToolButton::clicked, this, [this] {
        Selection selection;
        selection.nodes = {m_node};
        m_document->setSelection(selection);
        emit paramRequested(m_key);
    });
    update();
}

void ProblemButton::update()
{
    m_message.clear();
    m_key.clear();
    // The active tree first, then whichever comes first.
    const Node* culprit = nullptr;
    for (const Node& node : m_document->scene().nodes()) {
        if (!m_document->problem(node.id))
            continue;
        if (!culprit || node.id == m_document->selection().activeNode())
            culprit = &node;
    }
    if (culprit) {
        Error error = *m_document->problem(culprit->id);
        m_node = culprit->id;
        const ParamDef* def = findParam(error.path);
        QString name = QString::fromStdString(culprit->name);
        if (def) {
            m_key = QString::fromLatin1(def->key);
            name += QStringLiteral(", ") + coreText(def->label);
            error.path.clear();
        }
        m_message = QStringLiteral("%1, %2").arg(name, errorTextWithPlace(error));
    }
    setToolTip(m_message);
    setAccessibleName(m_message);
    elide();
    setVisible(!m_message.isEmpty());
}

void ProblemButton::elide()
{
    setText(fontMetrics().elidedText(m_message, Qt::ElideRight, std::max(40, width() - 40)));
}

QSize ProblemButton::minimumSizeHint() const
{
    return {60, QToolButton::minimumSizeHint().height()};
}

void ProblemButton::resizeEvent(QResizeEvent* event)
{
    QToolButton::resizeEvent(event);
    elide();
}

} // namespace ramure
