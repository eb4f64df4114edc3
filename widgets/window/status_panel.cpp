#include "widgets/window/status_panel.h"

#include "core/qt/session/jobs/analysis.h"
#include "core/qt/session/jobs/recompute.h"
#include "core/qt/session/motion/player.h"
#include "core/scene/kinds/node_kinds.h"
#include "widgets/base/named.h"
#include "widgets/base/progress_steps.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/icons.h"
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMouseEvent>
#include <QProgressBar>
#include <QStyle>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <limits>

namespace ramure {
namespace {

constexpr double leastMs = 0.05; ///< less is shown as no time at all: nothing was computed
const QString separator = QStringLiteral("  ·  ");

int pluralCount(quint64 count)
{
    return static_cast<int>(std::min<quint64>(count, std::numeric_limits<int>::max()));
}

/// These texts change with every move of a slider. A label of a fixed size has the window laid out again only
/// where a text needs more room than any before it.
void showText(QLabel* label, const QString& text)
{
    if (label->text() == text)
        return;
    label->setText(text);
    const QSize room = label->minimumSize();
    const QSize needed = label->sizeHint().expandedTo(room);
    if (needed != room)
        label->setFixedSize(needed);
}

/// In another language or style the texts need another room.
void forgetRoom(QLabel* label)
{
    label->clear();
    label->setMinimumSize(0, 0);
    label->setMaximumSize(QWIDGETSIZE_MAX, QWIDGETSIZE_MAX);
}

} // namespace

SceneTotals sceneTotals(const Document& document, const Analysis* analysis)
{
    SceneTotals totals;
    for (const Node& node : document.scene().nodes()) {
        if (node.kind != NodeKind::Tree)
            continue;
        ++totals.trees;
        const NodeResult* result = document.result(node.id);
        if (!result)
            continue;
        totals.failed = totals.failed || document.problem(node.id);
        totals.draft = totals.draft || result->draft;
        totals.seconds += result->tree.seconds;
        if (result->tree.simplified && document.scene().isShown(node.id))
            totals.branches += result->tree.simplified->skeleton.size();
        if (!result->tree.report)
            continue;
        ++totals.results;
        const auto findings = analysis ? analysis->findings(node.id) : nullptr;
        totals.verdict = std::max(totals.verdict,
                                  verdictOn(*result->tree.report, findings ? &findings->crossings : nullptr,
                                            result->tree.branches ? result->tree.branches->roots : 0));
        totals.crossings += findings ? findings->crossings.total() : 0;
        totals.reports.emplace_back(QString::fromStdString(node.name), result->tree.report);
    }
    return totals;
}

StatusPanel::StatusPanel(Document* document, Recompute* recompute, QWidget* parent)
    : StatusPanel(document, recompute, nullptr, parent)
{
}

StatusPanel::StatusPanel(Document* document, Recompute* recompute, Analysis* analysis, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_recompute(recompute)
    , m_analysis(analysis)
    , m_progress(new QProgressBar(this))
    , m_cancel(new QToolButton(this))
    , m_bark(named(new QLabel(tr("Making the bark…"), this), "barkMissing"))
    , m_counts(new QLabel(this))
    , m_time(named(new QLabel(this), "dim"))
    , m_hash(named(new QLabel(this), "dim"))
    , m_badge(named(new QLabel(this), "badge"))
    , m_patience(new QTimer(this))
    , m_barkPatience(new QTimer(this))
{
    auto* layout = layoutOf<QHBoxLayout>(this, 12, {8, 3, 8, 3});
    m_progress->setRange(0, progressSteps);
    m_progress->setTextVisible(false);
    m_progress->setFixedWidth(120);
    m_cancel->setAutoRaise(true);
    m_cancel->setIcon(icon("cancel"));
    m_cancel->setIconSize({14, 14});
    // The height of this bar, and of the viewport above it, must stay when a computation starts and ends: the
    // place of the button is kept while it is hidden, and the progress bar takes whatever height there is.
    m_progress->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored);
    QSizePolicy kept = m_cancel->sizePolicy();
    kept.setRetainSizeWhenHidden(true);
    m_cancel->setSizePolicy(kept);
    m_hash->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_badge->setAlignment(Qt::AlignCenter);
    m_badge->setCursor(Qt::PointingHandCursor);
    m_badge->installEventFilter(this);
    m_counts->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_time->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    for (QWidget* widget : {static_cast<QWidget*>(m_progress), static_cast<QWidget*>(m_cancel),
                            static_cast<QWidget*>(m_bark)}) {
        layout->addWidget(widget);
        widget->hide();
    }
    for (QLabel* label : {m_counts, m_time, m_hash, m_badge})
        layout->addWidget(label);
    for (QTimer* patience : {m_patience, m_barkPatience}) {
        patience->setSingleShot(true);
        patience->setInterval(patienceMs);
    }
    follow();
    m_cancel->setToolTip(tr("Stop computing; the draft stays"));
    m_cancel->setAccessibleName(tr("Stop computing"));
    m_progress->setAccessibleName(tr("Progress of the computation"));
    m_bark->setToolTip(
        tr("The picture of the bark is being made; until it is there, the bark has one colour."));
    m_time->setToolTip(tr(
        "Time to build the trees, without drawing. “cached”: nothing had to be built, the results of before "
        "still hold."));
    measureAnew();
}

/// What there is to say comes from the work, the checks and the document.
void StatusPanel::follow()
{
    connect(m_patience, &QTimer::timeout, this, &StatusPanel::showBusy);
    connect(m_barkPatience, &QTimer::timeout, m_bark, &QWidget::show);
    connect(m_cancel, &QToolButton::clicked, this, [this] {
        m_recompute->cancel();
        if (m_player && m_player->isBusy())
            m_player->cancel();
    });
    connect(m_recompute, &Recompute::busyChanged, this, [this](bool busy) {
        if (busy) {
            m_progress->setValue(0);
            m_patience->start();
        } else if (!isBusy()) {
            m_patience->stop();
            showBusy();
        }
        update();
    });
    connect(m_recompute, &Recompute::progress, this,
            [this](double fraction) { m_progress->setValue(static_cast<int>(fraction * progressSteps)); });
    if (m_analysis)
        connect(m_analysis, &Analysis::changed, this, [this] {
            showHash();
            showBadge(sceneTotals(*m_document, m_analysis));
        });
    connect(m_document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeSelection))
            showHash();
        if (change.has(changeResults | changeReset | changeStructure | changeParams | changeBranches |
                       changeNodeState | changeJoints))
            update();
    });
}

/// While it plays, frames follow each other too quickly to be told.
void StatusPanel::follow(Player* player)
{
    m_player = player;
    connect(player, &Player::busyChanged, this, [this](bool busy) {
        if (busy && !m_player->isPlaying() && !m_recompute->isBusy()) {
            m_progress->setValue(0);
            m_patience->start();
        } else if (!isBusy()) {
            m_patience->stop();
            showBusy();
        }
    });
    connect(player, &Player::progress, this, [this](double fraction) {
        if (!m_recompute->isBusy())
            m_progress->setValue(static_cast<int>(fraction * progressSteps));
    });
}

void StatusPanel::setMakesBark(bool makes)
{
    if (makes)
        return m_barkPatience->start();
    m_barkPatience->stop();
    m_bark->hide();
}

bool StatusPanel::isBusy() const
{
    return m_recompute->isBusy() || (m_player && m_player->isBusy() && !m_player->isPlaying());
}

QString StatusPanel::countsText() const
{
    return m_counts->text();
}

QString StatusPanel::hashText() const
{
    return m_hash->text();
}

/// Of the active tree, or of the first.
void StatusPanel::showHash()
{
    std::shared_ptr<const MeshAnalysis> findings;
    if (m_analysis) {
        findings = m_analysis->findings(m_document->selection().activeNode());
        for (const Node& node : m_document->scene().nodes())
            if (!findings)
                findings = m_analysis->findings(node.id);
    }
    showText(m_hash,
             findings ? QStringLiteral("#") + QString::fromStdString(findings->hash.shortText()) : QString());
    m_hash->setToolTip(
        findings ? tr("Hash of the mesh: %1").arg(QString::fromStdString(findings->hash.text())) : QString());
}

QString StatusPanel::badgeState() const
{
    return m_badge->property("state").toString();
}

void StatusPanel::showBusy()
{
    const bool busy = isBusy();
    m_progress->setVisible(busy);
    m_cancel->setVisible(busy);
}

void StatusPanel::setBadge(const QString& state, const QString& text, const QString& tip)
{
    showText(m_badge, text);
    m_badge->setToolTip(tip + QStringLiteral("<p>%1</p>").arg(tr("A click opens the Validation panel.")));
    m_badge->setAccessibleName(text);
    if (badgeState() == state)
        return;
    m_badge->setProperty("state", state);
    m_badge->style()->unpolish(m_badge);
    m_badge->style()->polish(m_badge);
}

QString StatusPanel::timeText(double seconds)
{
    const QLocale locale;
    const double ms = seconds * 1000.0;
    if (ms < leastMs)
        return tr("cached");
    return ms < 1000.0 ? tr("%1 ms").arg(locale.toString(ms, 'f', ms < 10.0 ? 1 : 0))
                       : tr("%1 s").arg(locale.toString(seconds, 'f', 1));
}

QString StatusPanel::reportTip(const SceneTotals& totals) const
{
    const QLocale locale;
    QString tip;
    for (const auto& [name, report] : totals.reports) {
        const std::pair<QString, quint64> counts[] = {
            {tr("Boundary edges"), report->boundaryEdges},
            {tr("Non-manifold edges"), report->nonManifoldEdges},
            {tr("Non-manifold vertices"), report->nonManifoldVertices},
            {tr("Inconsistent edges"), report->inconsistentEdges},
            {tr("Duplicate vertices"), report->duplicateVertices},
            {tr("Duplicate faces"), report->duplicateFaces},
            {tr("Degenerate faces"), report->degenerateFaces},
            {tr("Isolated vertices"), report->isolatedVertices},
            {tr("Components"), report->components},
        };
        QString rows;
        for (const auto& [label, count] : counts)
            rows += QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td align=right>%2</td></tr>")
                        .arg(label, locale.toString(count));
        rows += QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td align=right>%2</td></tr>")
                    .arg(tr("Euler characteristic"), locale.toString(qint64{report->eulerCharacteristic}));
        tip += QStringLiteral("<p><b>%1</b></p><table>%2</table>").arg(name.toHtmlEscaped(), rows);
    }
    return tip;
}

void StatusPanel::update()
{
    const SceneTotals totals = sceneTotals(*m_document, m_analysis);
    showHash();
    showCounts(totals);
    showBadge(totals);
}

/// What an export of everything visible writes, at rest.
void StatusPanel::showCounts(const SceneTotals& totals)
{
    const SceneCounts counts =
        m_counter.count(m_document->scene(), {}, [this](const Node& node, Stage, const Progress&) {
            const NodeResult* result = m_document->result(node.id);
            return result ? Expected<TreeResult>(result->tree) : fail(ErrorCode::Invalid, "");
        });
    if (totals.draft && (totals.results < totals.trees || !counts.complete))
        return; // a draft has no mesh to count: the numbers of before stay until there are others
    const PartCount all = counts.total();
    QStringList words;
    if (all.faces > 0)
        words += tr("%Ln triangle(s)", nullptr, pluralCount(all.faces));
    if (totals.branches > 0)
        words += tr("%Ln branch(es)", nullptr, pluralCount(totals.branches));
    if (words.isEmpty() && counts.complete)
        words += tr("Nothing visible");
    showText(m_counts, words.join(separator));
    m_counts->setToolTip(countsTip(counts));
    showText(m_time, totals.results > 0 ? timeText(totals.seconds) : QString());
}

/// Part by part.
QString StatusPanel::countsTip(const SceneCounts& counts)
{
    std::vector<std::pair<PartCount, QString>> parts = {{counts.of(ScenePart::Branches), tr("Branches")},
                                                        {counts.of(ScenePart::Leaves), tr("Leaves")},
                                                        {counts.of(ScenePart::Apples), tr("Fruit")}};
    for (const NodeKindRow* row : nodeKinds())
        parts.emplace_back(counts.of(row->kind), coreText(row->many));
    const QLocale locale;
    const auto line = [](const QString& name, const QString& vertices, const QString& faces) {
        const QString cell = QStringLiteral("<td align=right>&nbsp;&nbsp;%1</td>");
        return QStringLiteral("<tr><td>%1</td>").arg(name) + cell.arg(vertices) + cell.arg(faces) +
               QStringLiteral("</tr>");
    };
    QString rows = line({}, tr("vertices"), tr("faces"));
    for (const auto& [count, name] : parts)
        if (count.vertices > 0)
            rows += line(name, locale.toString(qulonglong(count.vertices)),
                         locale.toString(qulonglong(count.faces)));
    return QStringLiteral("<p>%1</p><table>%2</table>")
        .arg(tr("Counts of the visible nodes, as an export writes them. Branches are counted after "
                "simplification."),
             rows);
}

void StatusPanel::showBadge(const SceneTotals& totals)
{
    m_badge->setVisible(totals.trees > 0);
    if (totals.failed)
        return setBadge(QStringLiteral("bad"), tr("error"),
                        tr("The parameters give no tree; you see the last one that worked."));
    if (totals.results < totals.trees || totals.draft || m_recompute->isBusy())
        return setBadge(QStringLiteral("busy"), tr("computing…"),
                        tr("A quick draft is shown until the full result is there."));
    switch (totals.verdict) {
    case MeshVerdict::Clean:
        return setBadge(QStringLiteral("good"), tr("closed"),
                        tr("<p>Closed, 2-manifold and outward: every edge has two faces. No triangle runs "
                           "through another.</p>") +
                            reportTip(totals));
    case MeshVerdict::Closed:
        return setBadge(QStringLiteral("closed"), tr("closed"),
                        tr("<p>Closed, 2-manifold and outward: every edge has two faces. Whether triangles "
                           "run through each other has not been looked for yet.</p>") +
                            reportTip(totals));
    case MeshVerdict::Crossing: // of weight for a print alone, whose page tells them
        return setBadge(
            QStringLiteral("closed"), tr("closed"),
            tr("<p>Closed, 2-manifold and outward: every edge has two faces. %Ln pair(s) of triangles "
               "run through each other, as twigs do that touch: that matters for a print, which "
               "can be made without.</p>",
               nullptr, pluralCount(totals.crossings)) +
                reportTip(totals));
    case MeshVerdict::Broken:
        break;
    }
    setBadge(QStringLiteral("bad"), tr("broken"), reportTip(totals));
}

void StatusPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange)
        measureAnew();
}

/// In a small window what the hand does comes before figures of the computation.
void StatusPanel::fitWindow()
{
    constexpr int narrow = 1180;
    const bool fits = window()->width() >= narrow;
    m_time->setVisible(fits);
    m_hash->setVisible(fits);
}

void StatusPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    window()->installEventFilter(this);
    fitWindow();
}

bool StatusPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == window() && event->type() == QEvent::Resize && watched != this)
        fitWindow();
    if (watched == m_badge && event->type() == QEvent::MouseButtonRelease) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        if (mouse->button() == Qt::LeftButton && m_badge->rect().contains(mouse->position().toPoint()))
            emit reportRequested();
    }
    return QWidget::eventFilter(watched, event);
}

/// A style sheet that comes later brings other margins.
void StatusPanel::measureAnew()
{
    for (QLabel* label : {m_counts, m_time, m_badge, m_hash})
        forgetRoom(label);
    update();
}

} // namespace ramure
