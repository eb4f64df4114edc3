#include "widgets/panels/validation/analysis_strip.h"

#include "core/qt/session/jobs/shape_checks.h"
#include "widgets/base/named.h"
#include "widgets/base/progress_steps.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/icons.h"
#include "widgets/panels/validation/histogram_view.h"
#include "widgets/panels/validation/report_text.h"
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace ramure {
namespace {

constexpr int sliverBins = 1; ///< under 5 degrees a triangle shades and simulates badly

QLabel* textLabel(QWidget* parent)
{
    auto* label = new QLabel(parent);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

} // namespace

AnalysisStrip::AnalysisStrip(Analysis* analysis, QWidget* parent)
    : QWidget(parent)
    , m_analysis(analysis)
    , m_text(named(textLabel(this), "analysisText"))
    , m_shape(named(textLabel(this), "qualityText"))
    , m_hash(named(textLabel(this), "hashText"))
    , m_histogram(new HistogramView(this))
    , m_progress(named(new QProgressBar(this), "analysisProgress"))
    , m_cancel(named(new QToolButton(this), "cancelAnalysis"))
    , m_again(named(new QPushButton(tr("Look again"), this), "startAnalysis"))
    , m_separate(named(new QPushButton(tr("Move apart…"), this), "separateCollisions"))
{
    m_hash->setForegroundRole(QPalette::PlaceholderText);
    m_progress->setRange(0, progressSteps);
    m_progress->setTextVisible(false);
    m_cancel->setIcon(icon("cancel"));
    m_cancel->setIconSize({14, 14});
    m_cancel->setAutoRaise(true);
    auto* layout = layoutOf<QVBoxLayout>(this, 5, {12, 2, 8, 8});
    auto* work = new QHBoxLayout;
    work->setSpacing(6);
    work->addWidget(m_progress, 1);
    work->addWidget(m_cancel);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_again);
    buttons->addWidget(m_separate);
    buttons->addStretch(1);
    layout->addWidget(m_text);
    layout->addLayout(work);
    layout->addLayout(buttons);
    layout->addWidget(m_shape);
    layout->addWidget(m_histogram);
    layout->addWidget(m_hash);
    connectParts();
}

void AnalysisStrip::connectParts()
{
    connect(m_cancel, &QToolButton::clicked, this, [this] {
        if (m_isShape)
            m_shapes->cancel();
        else
            m_analysis->cancel(m_node);
    });
    connect(m_again, &QPushButton::clicked, this, [this] {
        if (m_isShape)
            m_shapes->start();
        else
            m_analysis->start(m_node);
    });
    connect(m_separate, &QPushButton::clicked, this, [this] { emit separateRequested(m_node); });
    connect(m_analysis, &Analysis::changed, this, [this](NodeId tree) {
        if (tree == m_node)
            refresh();
    });
    connect(m_analysis, &Analysis::progress, this, [this](NodeId tree, double fraction) {
        if (tree == m_node)
            m_progress->setValue(static_cast<int>(fraction * progressSteps));
    });
    m_cancel->setToolTip(tr("Stop looking"));
    m_cancel->setAccessibleName(m_cancel->toolTip());
    m_progress->setAccessibleName(tr("Progress of the search"));
    m_separate->setToolTip(
        tr("Turn the thinner branch of each colliding pair as little as it takes. Lengths stay."));
    m_hash->setToolTip(
        tr("A name for the mesh: equal on every machine where all positions and triangles are equal"));
    m_histogram->setToolTip(
        tr("Triangles by their smallest angle, from 0° to 60°; the height is the square root "
           "of their number"));
    m_histogram->setAccessibleName(tr("Triangles by their smallest angle"));
    refresh();
}

void AnalysisStrip::setShapes(ShapeChecks* shapes)
{
    m_shapes = shapes;
    connect(shapes, &ShapeChecks::changed, this, [this](NodeId node) {
        if (node == m_node)
            refresh();
    });
    connect(shapes, &ShapeChecks::progress, this, [this](NodeId node, double fraction) {
        if (node == m_node)
            m_progress->setValue(static_cast<int>(fraction * progressSteps));
    });
}

void AnalysisStrip::setNode(NodeId node, bool isShape)
{
    m_node = node;
    m_isShape = isShape && m_shapes;
    refresh();
}

Analysis::State AnalysisStrip::state() const
{
    return m_isShape ? m_shapes->state() : m_analysis->state(m_node);
}

std::shared_ptr<const MeshAnalysis> AnalysisStrip::findings() const
{
    if (!m_isShape)
        return m_analysis->findings(m_node);
    const auto outcome = m_shapes->outcome();
    return outcome ? outcome->analysis : nullptr;
}

double AnalysisStrip::fraction() const
{
    return m_isShape ? m_shapes->fraction() : m_analysis->fraction(m_node);
}

void AnalysisStrip::refresh()
{
    const Analysis::State now = state();
    const auto found = findings();
    setVisible(now != Analysis::State::None);
    m_text->setText(found ? ReportTexts::crossings(*found) : stateText(now));
    m_text->setVisible(!m_text->text().isEmpty());
    showWork(now);
    showFindings(found.get());
}

void AnalysisStrip::showWork(Analysis::State state)
{
    using State = Analysis::State;
    const bool works = state == State::Waiting || state == State::Running;
    m_progress->setVisible(works);
    m_progress->setValue(static_cast<int>(fraction() * progressSteps));
    m_cancel->setVisible(works);
    m_again->setVisible(state == State::Cancelled || state == State::Failed);
}

QString AnalysisStrip::stateText(Analysis::State state) const
{
    switch (state) {
    case Analysis::State::Waiting:
    case Analysis::State::Running:
        return tr("Looking for triangles that run through each other…");
    case Analysis::State::Cancelled:
        return tr("Whether triangles run through each other is not known: the search was stopped.");
    case Analysis::State::Failed:
        return errorText(m_analysis->error(m_node).value_or(Error{}));
    case Analysis::State::None:
    case Analysis::State::Done:
        break;
    }
    return {};
}

void AnalysisStrip::showFindings(const MeshAnalysis* findings)
{
    const bool measured = findings && findings->quality.smallestAngleFace != noIndex;
    m_separate->setVisible(findings && !findings->collisions.empty());
    m_hash->setVisible(findings != nullptr);
    m_shape->setVisible(measured);
    m_histogram->setVisible(measured);
    if (!findings)
        return;
    m_hash->setText(tr("Hash %1").arg(QString::fromStdString(findings->hash.text())));
    if (!measured)
        return;
    m_shape->setText(ReportTexts::quality(findings->quality));
    m_histogram->setCounts({findings->quality.angles.begin(), findings->quality.angles.end()}, sliverBins);
}

} // namespace ramure
