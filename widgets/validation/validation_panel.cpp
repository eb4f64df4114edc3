#include "widgets/validation/validation_panel.h"

#include "core/document/analysis.h"
#include "core/document/document.h"
#include "core/scene/places.h"
#include "widgets/inspector/only_branch.h"
#include "widgets/support/empty_page.h"
#include "widgets/theme/icons.h"
#include "widgets/validation/analysis_strip.h"
#include "widgets/validation/kind_texts.h"
#include "widgets/validation/report_text.h"
#include "widgets/validation/report_view.h"
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace ramure {
namespace {

constexpr quint32 newsThatMatter =
    changeSelection | changeResults | changeReset | changeNodeState | changeStructure;

/// The tree whose mesh is looked at: that of the selected branches, the active node, or, while something else
/// or nothing is selected, the one before; else the first.
NodeId treeToShow(const Document& document, NodeId before)
{
    const auto isTree = [&document](NodeId id) {
        const Node* node = document.scene().find(id);
        return node && node->kind == NodeKind::Tree;
    };
    for (const NodeId id : {document.selection().branchNode, document.selection().activeNode(), before})
        if (isTree(id))
            return id;
    for (const Node& node : document.scene().nodes())
        if (node.kind == NodeKind::Tree)
            return node.id;
    return noNode;
}

} // namespace

struct ValidationPanel::Private
{
    Private(ValidationPanel* panel, Document* ofDocument, Analysis* ofMeshes)
        : q(panel)
        , document(ofDocument)
        , analysis(ofMeshes)
    {
    }

    void build();
    QWidget* buildHead(QWidget* parent);
    QWidget* buildExplanation(QWidget* parent);
    void refresh();
    void showSummary();
    void explain();
    void activate(const QModelIndex& index);
    void selectBranch(Index branch);
    void highlight(const DefectPlace& place);
    void showCollision(const Collision& collision);
    [[nodiscard]] std::shared_ptr<const MeshAnalysis> findings() const;
    void retranslate();
    void leave();

    ValidationPanel* q;
    Document* document;
    Analysis* analysis;
    AnalysisStrip* strip = nullptr;
    QStackedWidget* pages = nullptr;
    EmptyPage* empty = nullptr;
    StatusBadge* badge = nullptr;
    QLabel* tree = nullptr;
    QLabel* headline = nullptr;
    QLabel* details = nullptr;
    QToolButton* copy = nullptr;
    ReportModel* model = nullptr;
    ReportView* view = nullptr;
    QLabel* explanation = nullptr;
    NodeId node = noNode;
    bool highlighted = false; ///< a defect was handed to the viewport
};

ValidationPanel::ValidationPanel(Document* document, QWidget* parent)
    : ValidationPanel(document, nullptr, parent)
{
}

ValidationPanel::ValidationPanel(Document* document, Analysis* analysis, QWidget* parent)
    : QWidget(parent)
    , d(std::make_unique<Private>(this, document, analysis))
{
    setObjectName(QStringLiteral("validationPanel"));
    d->build();
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(newsThatMatter))
            d->refresh();
    });
    if (analysis)
        connect(analysis, &Analysis::changed, this, [this](NodeId tree) {
            if (tree == d->node)
                d->refresh();
        });
    d->retranslate();
}

ValidationPanel::~ValidationPanel() = default;

void ValidationPanel::Private::build()
{
    auto* outer = new QVBoxLayout(q);
    outer->setContentsMargins(0, 0, 0, 0);
    pages = new QStackedWidget(q);
    outer->addWidget(pages);
    empty = new EmptyPage(pages);
    pages->addWidget(empty);

    auto* content = new QWidget(pages);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(buildHead(content));
    if (analysis) {
        strip = new AnalysisStrip(analysis, content);
        layout->addWidget(strip);
        QObject::connect(strip, &AnalysisStrip::separateRequested, q, &ValidationPanel::separateRequested);
    }
    auto* splitter = new QSplitter(Qt::Vertical, content);
    splitter->setChildrenCollapsible(false);
    model = new ReportModel(q);
    view = new ReportView(model, splitter);
    splitter->addWidget(view);
    splitter->addWidget(buildExplanation(splitter));
    splitter->setStretchFactor(0, 1);
    splitter->setSizes({300, 190});
    layout->addWidget(splitter, 1);
    pages->addWidget(content);

    QObject::connect(view, &ReportView::chosen, q, [this](const QModelIndex& index) { activate(index); });
    QObject::connect(view->selectionModel(), &QItemSelectionModel::currentChanged, q, [this] { explain(); });
    QObject::connect(model, &QAbstractItemModel::modelReset, q, [this] {
        leave();
        explain();
    });
    QObject::connect(copy, &QToolButton::clicked, q, &ValidationPanel::copyReport);
}

QWidget* ValidationPanel::Private::buildHead(QWidget* parent)
{
    auto* head = new QWidget(parent);
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(12, 8, 8, 8);
    row->setSpacing(10);
    badge = new StatusBadge(head);
    row->addWidget(badge, 0, Qt::AlignTop);
    auto* texts = new QVBoxLayout;
    texts->setSpacing(2);
    headline = new QLabel(head);
    headline->setObjectName(QStringLiteral("panelTitle"));
    headline->setWordWrap(true);
    tree = new QLabel(head);
    tree->setTextFormat(Qt::PlainText);
    tree->setForegroundRole(QPalette::PlaceholderText);
    details = new QLabel(head);
    details->setObjectName(QStringLiteral("reportDetails"));
    details->setTextFormat(Qt::PlainText);
    details->setWordWrap(true);
    details->setTextInteractionFlags(Qt::TextSelectableByMouse);
    texts->addWidget(headline);
    texts->addWidget(tree);
    texts->addWidget(details);
    row->addLayout(texts, 1);
    copy = new QToolButton(head);
    copy->setObjectName(QStringLiteral("copyReport"));
    copy->setIcon(icon("copy"));
    copy->setAutoRaise(true);
    row->addWidget(copy, 0, Qt::AlignTop);
    return head;
}

QWidget* ValidationPanel::Private::buildExplanation(QWidget* parent)
{
    auto* scroll = new QScrollArea(parent);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumHeight(80);
    explanation = new QLabel(scroll);
    explanation->setObjectName(QStringLiteral("explanation"));
    explanation->setTextFormat(Qt::RichText);
    explanation->setWordWrap(true);
    explanation->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    explanation->setContentsMargins(12, 4, 12, 8);
    explanation->setTextInteractionFlags(Qt::TextSelectableByMouse);
    scroll->setWidget(explanation);
    return scroll;
}

void ValidationPanel::Private::refresh()
{
    if (!q->isVisible())
        return; // showEvent catches up
    const NodeId shown = treeToShow(*document, node);
    if (shown != node)
        leave();
    node = shown;
    pages->setCurrentIndex(node == noNode ? 0 : 1);
    const NodeResult* result = document->result(node);
    if (result && !result->error)
        model->setSource({result->tree.report, result->tree.branches, result->tree.simplified, findings()});
    else
        model->setSource({});
    view->setVisible(model->rowCount() > 0);
    if (strip)
        strip->setTree(node);
    showSummary();
}

std::shared_ptr<const MeshAnalysis> ValidationPanel::Private::findings() const
{
    return analysis ? analysis->findings(node) : nullptr;
}

void ValidationPanel::Private::showSummary()
{
    const Node* shown = document->scene().find(node);
    const ReportSummary state = summarise(document->result(node), findings().get());
    badge->setStatus(state.status);
    badge->setAccessibleName(state.headline);
    headline->setText(state.headline);
    details->setText(state.details);
    tree->setText(shown ? QString::fromStdString(shown->name) : QString());
    explain();
}

void ValidationPanel::Private::explain()
{
    const QModelIndex current = view->currentIndex();
    QString text;
    if (current.isValid())
        text = richText(std::visit([](auto kind) { return kindText(kind); }, model->kind(current)));
    else if (badge->status() == StatusBadge::Status::Good)
        text = richText(cleanText());
    else if (model->rowCount() > 0)
        text = richText(
            {tr("What this means"), tr("Choose a kind above to read what it is and what it does."), {}, {}});
    explanation->setText(text);
}

void ValidationPanel::Private::activate(const QModelIndex& index)
{
    const ReportSource& source = model->source();
    if (const RepairNote* note = model->repair(index)) {
        leave();
        return selectBranch(note->branch);
    }
    if (!source.branches)
        return;
    const TriangleMesh& mesh = source.branches->mesh;
    const glm::dmat4 world = placeAt(document->scene(), node, 0.0).geometry;
    if (const Defect* defect = model->defect(index)) {
        const DefectPlace place = defectPlace(mesh, *defect, world);
        selectBranch(defectBranch(mesh, *defect));
        highlight(place);
    } else if (const FacePair* pair = model->crossing(index)) {
        const DefectPlace place = facesPlace(mesh, {pair->first, pair->second}, world);
        selectBranch(faceBranch(mesh, pair->first));
        highlight(place);
    } else if (const WorstFace* face = model->thinTriangle(index)) {
        const DefectPlace place = facesPlace(mesh, {face->face, noIndex}, world);
        selectBranch(faceBranch(mesh, face->face));
        highlight(place);
    } else if (const Collision* collision = model->collision(index)) {
        showCollision(*collision);
    }
}

/// Both branches are selected; the point where they cross is framed with the thicker one around it.
void ValidationPanel::Private::showCollision(const Collision& collision)
{
    const auto simplified = model->source().simplified;
    if (!simplified || std::max(collision.first, collision.second) >= simplified->skeleton.size())
        return;
    const Skeleton& skeleton = simplified->skeleton;
    const double thick = std::max(skeleton.a0[collision.first], skeleton.a0[collision.second]);
    const DefectPlace place = pointPlace(collision.place, std::max(6.0 * thick, 4.0 * collision.depth),
                                         placeAt(document->scene(), node, 0.0).geometry);
    document->setSelection({{node}, node, {collision.first, collision.second}, collision.first});
    highlight(place);
}

void ValidationPanel::Private::highlight(const DefectPlace& place)
{
    highlighted = true;
    emit q->defectActivated(node, place);
}

void ValidationPanel::Private::selectBranch(Index branch)
{
    if (branch != noIndex)
        document->setSelection(onlyBranch(node, branch));
}

void ValidationPanel::Private::leave()
{
    if (!highlighted)
        return;
    highlighted = false;
    emit q->defectLeft();
}

void ValidationPanel::Private::retranslate()
{
    empty->setText(tr("The check of a tree's mesh stands here. There is no tree in the scene."));
    copy->setToolTip(tr("Copy the report as text"));
    copy->setAccessibleName(copy->toolTip());
    view->setAccessibleName(tr("Defects and repairs"));
    q->setAccessibleName(tr("Mesh check"));
    model->retranslate();
    if (strip)
        strip->retranslate();
    showSummary();
}

QSize ValidationPanel::sizeHint() const
{
    return {340, 420};
}

void ValidationPanel::copyReport()
{
    if (d->node == noNode)
        return;
    const Node* tree = d->document->scene().find(d->node);
    const QString name = tree ? QString::fromStdString(tree->name) : QString();
    QGuiApplication::clipboard()->setText(
        reportText(name, d->document->result(d->node), d->findings().get()));
    emit messageRaised(tr("Report copied as text"));
}

void ValidationPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        d->retranslate();
}

void ValidationPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    d->refresh();
}

} // namespace ramure
