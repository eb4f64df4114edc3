#include "widgets/panels/inspector/branch_inspector.h"

#include "core/qt/document/document.h"
#include "core/skeleton/branch_facts.h"
#include "core/surface/foliage/branch_masses.h"
#include "widgets/base/empty_page.h"
#include "widgets/base/named.h"
#include "widgets/base/only_branch.h"
#include "widgets/base/texts/branch_names.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/panels/inspector/branch_fact_form.h"
#include "widgets/panels/inspector/roll_editor.h"
#include "widgets/panels/inspector/section_browser.h"
#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>
#include <optional>
#include <span>

namespace ramure {
namespace {

constexpr quint32 branchNews =
    changeSelection | changeResults | changeReset | changeBranches | changeNodeState | changeStructure;

constexpr int leastHeight = 160;
constexpr int leastScroll = 60;

} // namespace

/// What a whole skeleton has to be asked once for, however many of its branches are looked at.
struct SkeletonCache
{
    std::shared_ptr<const SimplifiedSkeleton> simplified;
    std::shared_ptr<const Foliage> foliage;
    std::optional<BranchRows> rows;
    ChildLists children;
    std::vector<double> masses;

    void update(const TreeResult& tree)
    {
        if (tree.simplified == simplified && tree.foliage == foliage)
            return;
        if (tree.simplified != simplified)
            rows.emplace(tree);
        simplified = tree.simplified;
        foliage = tree.foliage;
        children = childLists(simplified->skeleton);
        masses = branchMasses(simplified->skeleton, foliage ? *foliage : Foliage());
    }
};

struct BranchInspector::Private
{
    Private(BranchInspector* inspector, Document* ofDocument)
        : q(inspector)
        , document(ofDocument)
    {
    }

    void build();
    void buildContent();
    void refresh();
    void showNothing(const QString& why);
    void showBranch(const NodeResult& result);
    void announce();
    void showTitle();
    [[nodiscard]] QString whyEmpty() const;
    [[nodiscard]] std::span<const Index> limb() const;
    [[nodiscard]] bool isLimbSelected() const;

    BranchInspector* q;
    Document* document;
    QStackedWidget* pages = nullptr;
    EmptyPage* empty = nullptr;
    QWidget* content = nullptr;
    QSplitter* parts = nullptr;
    QLabel* detailsTitle = nullptr;
    QLabel* title = nullptr;
    QLabel* subtitle = nullptr;
    BranchFactForm* form = nullptr;
    RollEditor* roll = nullptr;
    SectionBrowser* sections = nullptr;
    SkeletonCache cache;
    NodeId node = noNode;   ///< what is shown
    Index branch = noIndex; ///< what is shown
    bool announced = false; ///< the viewport shows a section
};

BranchInspector::BranchInspector(Document* document, QWidget* parent)
    : QWidget(parent)
    , d(std::make_unique<Private>(this, document))
{
    setObjectName(QStringLiteral("branchInspector"));
    d->build();
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(branchNews))
            d->refresh();
    });
    setAccessibleName(tr("Branch inspector"));
    d->empty->setText(d->whyEmpty());
}

BranchInspector::~BranchInspector() = default;

void BranchInspector::Private::build()
{
    auto* outer = layoutOf<QVBoxLayout>(q);
    pages = new QStackedWidget(q);
    outer->addWidget(pages);
    empty = new EmptyPage(pages);
    pages->addWidget(empty);

    // The sections stand below, in sight at any height; what there is to say about the branch scrolls above.
    parts = new QSplitter(Qt::Vertical, pages);
    parts->setChildrenCollapsible(false);
    auto* scroll = new QScrollArea(parts);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    content = named(new QWidget(scroll), "inspectorContent");
    scroll->setWidget(content);
    scroll->setMinimumHeight(leastScroll);
    parts->addWidget(scroll);

    auto* below = new QWidget(parts);
    auto* belowLayout = layoutOf<QVBoxLayout>(below, -1, {12, 6, 12, 8});
    sections = new SectionBrowser(below);
    belowLayout->addWidget(sections);
    buildContent();
    parts->addWidget(below);
    parts->setStretchFactor(0, 1);
    parts->setSizes({400, 180});
    pages->addWidget(parts);

    QObject::connect(form, &BranchFactForm::branchChosen, q,
                     [this](Index chosen) { document->setSelection(onlyBranch(node, chosen)); });
    QObject::connect(sections, &SectionBrowser::currentSectionChanged, q, [this] {
        showTitle();
        announce();
    });
    QObject::connect(sections, &SectionBrowser::messageRaised, q, &BranchInspector::messageRaised);
    QObject::connect(roll, &RollEditor::refused, q, &BranchInspector::messageRaised);
}

/// What scrolls: the branch, its roll, and the section looked at.
void BranchInspector::Private::buildContent()
{
    auto* layout = layoutOf<QVBoxLayout>(content, 6, {12, 8, 12, 8});
    title = named(new QLabel(content), "panelTitle");
    title->setTextFormat(Qt::PlainText);
    title->setTextInteractionFlags(Qt::TextSelectableByMouse);
    title->setWordWrap(true);
    subtitle = new QLabel(content);
    subtitle->setTextFormat(Qt::PlainText);
    subtitle->setForegroundRole(QPalette::PlaceholderText);
    subtitle->setWordWrap(true);
    form = new BranchFactForm(content);
    roll = new RollEditor(document, content);
    detailsTitle = named(new QLabel(content), "partTitle");
    layout->addWidget(title);
    layout->addWidget(subtitle);
    layout->addWidget(roll);
    layout->addSpacing(4);
    layout->addWidget(form);
    layout->addSpacing(8);
    layout->addWidget(detailsTitle);
    layout->addWidget(sections->details());
    layout->addStretch(1);
}

void BranchInspector::Private::refresh()
{
    if (!q->isVisible())
        return; // showEvent catches up
    const Selection& selection = document->selection();
    const NodeResult* result = document->result(selection.branchNode);
    const bool exists = result && result->tree.simplified && selection.activeBranch != noIndex &&
                        selection.activeBranch < result->tree.simplified->skeleton.size();
    if (!exists)
        return showNothing(whyEmpty());
    node = selection.branchNode;
    branch = selection.activeBranch;
    showBranch(*result);
    pages->setCurrentIndex(1);
    announce();
}

/// A tree without a skeleton is another matter than a tree without a choice.
QString BranchInspector::Private::whyEmpty() const
{
    const NodeResult* result = document->result(document->selection().activeNode());
    if (result && result->error && !result->tree.simplified)
        return tr("This tree has no branches: %1").arg(errorText(*result->error));
    return tr("Select a branch in the viewport or in the scene panel.");
}

void BranchInspector::Private::showNothing(const QString& why)
{
    node = noNode;
    branch = noIndex;
    cache = {};
    sections->setFacts({});
    roll->showBranches(noNode, {});
    empty->setText(why);
    pages->setCurrentIndex(0);
    announce();
}

void BranchInspector::Private::showBranch(const NodeResult& result)
{
    cache.update(result.tree);
    const Skeleton& skeleton = cache.simplified->skeleton;
    const SectionSet none;
    const bool fits =
        result.tree.sections && result.tree.sections->sections.size() ==
                                    std::size_t(skeleton.size()) * result.tree.sections->perBranch;
    const SectionSet& set = fits ? *result.tree.sections : none;
    form->setFacts(branchFacts(skeleton, cache.children, set, cache.masses, branch));
    sections->setFacts(sectionFacts(skeleton, set, branch));
    // A limb turns as a whole where its foot does: the turn of a branch goes on to those above it.
    std::vector<std::uint64_t> keys;
    if (isLimbSelected())
        keys.push_back(skeleton.key[limb().front()]);
    else
        for (const Index selected : document->selection().branches)
            keys.push_back(skeleton.key[selected]);
    roll->showBranches(node, std::move(keys));
    showTitle();
}

/// That has the branch.
std::span<const Index> BranchInspector::Private::limb() const
{
    return cache.rows->branches(cache.rows->axisOf(branch));
}

bool BranchInspector::Private::isLimbSelected() const
{
    return limb().size() > 1 && std::ranges::equal(limb(), document->selection().branches);
}

void BranchInspector::Private::showTitle()
{
    if (branch == noIndex)
        return;
    const BranchNames names;
    title->setText(isLimbSelected() ? names.axis(*cache.rows, cache.rows->axisOf(branch))
                                    : names.branch(*cache.rows, branch));
    detailsTitle->setText(tr("Section %1").arg(sections->currentSection() + 1));
    const bool some = sections->currentSection() >= 0;
    detailsTitle->setVisible(some);
    sections->details()->setVisible(some);
    const Node* tree = document->scene().find(node);
    const QString name =
        tr("%1 · branch %2 in reports")
            .arg(tree ? QString::fromStdString(tree->name) : QString(), QString::number(branch));
    const auto selected = static_cast<int>(document->selection().branches.size());
    subtitle->setText(isLimbSelected() ? tr("%1 · the whole limb is selected; the figures are those of: %2")
                                             .arg(name, names.part(*cache.rows, branch))
                      : selected > 1
                          ? tr("%1 · the active one of %n selected branch(es)", nullptr, selected).arg(name)
                          : name);
}

void BranchInspector::Private::announce()
{
    const int section = sections->currentSection();
    if (branch != noIndex && section >= 0 && q->isVisible()) {
        announced = true;
        emit q->sectionInspected(node, branch, static_cast<Index>(section));
    } else if (announced) {
        announced = false;
        emit q->sectionLeft();
    }
}

QSize BranchInspector::minimumSizeHint() const
{
    // What scrolls only up and down must not be cut at the side.
    const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this);
    return {std::max(d->content->minimumSizeHint().width() + bar, d->parts->minimumSizeHint().width()),
            leastHeight};
}

QSize BranchInspector::sizeHint() const
{
    return {340, 640};
}

void BranchInspector::setAngleUnit(AngleUnit unit)
{
    d->form->setAngleUnit(unit);
    d->roll->setAngleUnit(unit);
    d->sections->setAngleUnit(unit);
}

void BranchInspector::nextSection()
{
    d->sections->setCurrentSection(d->sections->currentSection() + 1);
}

void BranchInspector::previousSection()
{
    d->sections->setCurrentSection(d->sections->currentSection() - 1);
}

void BranchInspector::focusRoll()
{
    d->roll->setFocus(Qt::TabFocusReason);
}

void BranchInspector::copyCsv()
{
    d->sections->copyCsv(false);
}

void BranchInspector::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    d->refresh();
}

void BranchInspector::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    d->announce();
}

} // namespace ramure
