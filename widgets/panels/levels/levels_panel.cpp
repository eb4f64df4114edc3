#include "widgets/panels/levels/levels_panel.h"

#include "core/qt/session/export/level_export.h"
#include "widgets/base/empty_page.h"
#include "widgets/base/fields/level_form.h"
#include "widgets/base/fields/number_field.h"
#include "widgets/base/fields/number_slider.h"
#include "widgets/base/named.h"
#include "widgets/base/progress_steps.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/icons.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/levels/level_model.h"
#include "widgets/panels/levels/level_view.h"
#include <QCheckBox>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QStackedWidget>
#include <QStyle>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

const auto storedKey = QStringLiteral("levels"), lastGameKey = QStringLiteral("last/game");

/// One digit, not above.
double roundedDown(double value)
{
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    return power * std::floor(value / power);
}

std::int64_t facesOf(const TreeResult& tree)
{
    return (tree.branches ? tree.branches->mesh.faceCount() : 0) + tree.leaves.faceCount() +
           tree.apples.faceCount();
}

} // namespace

LevelsPanel::LevelsPanel(Document* document, Preferences* preferences, QWidget* parent)
    : LevelsPanel(document, new LevelWatch(document), preferences, parent)
{
}

LevelsPanel::LevelsPanel(Document* document, LevelWatch* watch, Preferences* preferences, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_preferences(preferences)
    , m_watch(watch)
    , m_model(new LevelModel(this))
{
    setObjectName(QStringLiteral("levelsPanel"));
    m_watch->setParent(this);
    build();
    takeStored();
    connect(m_form, &LevelForm::changed, this, &LevelsPanel::takeForm);
    connect(m_watch, &LevelWatch::changed, this, &LevelsPanel::follow);
    connect(m_watch, &LevelWatch::progress, this,
            [this](double fraction) { m_progress->setValue(static_cast<int>(fraction * progressSteps)); });
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeReset)) {
            m_metres.clear(); // ids are those of other trees
            m_metresOf = noNode;
            LevelOptions options = m_form->options();
            if (!std::exchange(options.distances, {}).empty())
                m_form->setOptions(options);
        }
        if (change.has(changeNodeState | changeSelection | changeReset | changeStructure))
            showState();
    });
    connectViews();
    m_progress->setAccessibleName(tr("Making the levels"));
    m_progress->setToolTip(m_progress->accessibleName());
    m_cancel->setToolTip(tr("Give this up"));
    m_cancel->setAccessibleName(tr("Cancel"));
    m_again->setToolTip(tr("Begins again with the tree as it is now"));
    m_table->setAccessibleName(tr("Levels of detail"));
    const QString tip = tr("From the eye to the tree, in metres: a game shows the level that takes over "
                           "before it. Arrow keys: a tenth nearer or farther");
    for (QWidget* each : {static_cast<QWidget*>(m_distanceLabel), static_cast<QWidget*>(m_slider),
                          static_cast<QWidget*>(m_field)}) {
        each->setToolTip(tip);
        each->setAccessibleName(tr("Distance"));
    }
    m_levelView->setAccessibleName(tr("The level from this distance"));
    m_wholeView->setAccessibleName(tr("The whole tree from this distance"));
    m_enlarged->setToolTip(tr("Shows both as through a long lens, to compare their shapes; else they have "
                              "the pixels of a screen 1080 pixels high"));
    m_sizeText->setToolTip(tr("A screen 1080 pixels high, with the view's angle of view, 40°"));
    m_export->setToolTip(tr("Opens the export for a game with these levels"));
    showShot();
    showState();
    follow();
}

void LevelsPanel::build()
{
    m_pages = new QStackedWidget(this);
    auto* outer = layoutOf<QVBoxLayout>(this);
    outer->addWidget(m_pages);
    m_empty = new EmptyPage(m_pages);
    auto* content = new QWidget;
    auto* scroll = new QScrollArea(m_pages);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(content);
    m_pages->addWidget(m_empty);
    m_pages->addWidget(scroll);
    auto* column = layoutOf<QVBoxLayout>(content, 7, {10, 8, 10, 8});
    buildState(column);
    buildTable(column);
    m_below = new QWidget(content);
    auto* below = layoutOf<QVBoxLayout>(m_below, 7);
    buildDistance(below);
    buildChoices(below);
    buildPictures(below);
    column->addWidget(m_below, 1000);
    column->addStretch(1); // where nothing is below
    m_table->hide();
    m_below->hide();
}

/// The tree, its budgets, and what is being done.
void LevelsPanel::buildState(QVBoxLayout* column)
{
    QWidget* content = column->parentWidget();
    m_title = named(new QLabel(content), "partTitle");
    m_title->setTextFormat(Qt::PlainText);
    m_form = new LevelForm(content);
    m_form->setNarrow();
    m_form->findChild<QSpinBox*>()->setObjectName(QStringLiteral("levelCount"));
    m_form->findChild<QLineEdit*>(QStringLiteral("exportBudgets"))
        ->setObjectName(QStringLiteral("levelBudgets"));
    m_form->findChild<QLineEdit*>(QStringLiteral("exportSwitches"))
        ->setObjectName(QStringLiteral("levelSwitches"));
    auto* formLabel = new QLabel(tr("Levels"), content);
    formLabel->setBuddy(m_form);
    auto* budgets = new QHBoxLayout;
    budgets->setSpacing(6);
    budgets->addWidget(formLabel, 0, Qt::AlignTop);
    formLabel->setMinimumHeight(m_form->findChild<QSpinBox*>()->sizeHint().height());
    budgets->addWidget(m_form, 1);
    m_state = new QLabel(content);
    m_state->setTextFormat(Qt::PlainText);
    m_state->setWordWrap(true);
    m_state->setMinimumHeight(m_state->fontMetrics().height() + 8);
    m_progress = named(new QProgressBar(content), "levelProgress");
    m_progress->setRange(0, progressSteps);
    m_progress->setTextVisible(false);
    m_cancel = named(new QToolButton(content), "cancelLevels");
    m_cancel->setIcon(icon("cancel"));
    m_cancel->setIconSize({14, 14});
    m_cancel->setAutoRaise(true);
    m_again = named(new QPushButton(tr("Make the levels"), content), "startLevels");
    auto* work = new QHBoxLayout;
    work->setSpacing(6);
    work->addWidget(m_state, 1);
    work->addWidget(m_progress, 1);
    work->addWidget(m_cancel);
    work->addWidget(m_again);
    column->addWidget(m_title);
    column->addLayout(budgets);
    column->addLayout(work);
    connect(m_cancel, &QToolButton::clicked, m_watch, &LevelWatch::cancel);
    connect(m_again, &QPushButton::clicked, m_watch, &LevelWatch::start);
}

void LevelsPanel::buildTable(QVBoxLayout* column)
{
    m_table = named(new QTreeView(column->parentWidget()), "levelTable");
    m_table->setModel(m_model);
    m_table->setRootIsDecorated(false);
    m_table->setUniformRowHeights(true);
    m_table->setAllColumnsShowFocus(true);
    m_table->setContextMenuPolicy(Qt::CustomContextMenu);
    QFont small = font(); // seven columns stand beside each other in a dock of the usual width
    small.setPointSizeF(0.88 * small.pointSizeF());
    m_table->setFont(small);
    small.setPointSizeF(0.78 * font().pointSizeF()); // the words are wider than the numbers below them
    m_table->header()->setFont(small);
    m_table->header()->setSectionsMovable(false);
    m_table->header()->setStretchLastSection(false);
    m_table->header()->setMinimumSectionSize(30);
    m_table->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->installEventFilter(this);
    column->addWidget(m_table);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) {
                if (now.isValid() && !m_shows)
                    showRow(now.row());
            });
    // The model is made anew by it, which no editor of a cell expects.
    connect(m_model, &LevelModel::edited, this, &LevelsPanel::takeEdited, Qt::QueuedConnection);
    connect(m_table, &QTreeView::doubleClicked, this, [this](const QModelIndex& at) { showRow(at.row()); });
    connect(m_table, &QWidget::customContextMenuRequested, this, &LevelsPanel::showMenu);
}

void LevelsPanel::buildDistance(QVBoxLayout* column)
{
    m_distanceLabel = new QLabel(tr("Distance"), m_below);
    m_slider = named(new NumberSlider(m_below), "levelDistance");
    m_field = named(new NumberField(m_below), "levelMetres");
    NumberFormat format;
    format.unit = ParamUnit::Metre;
    format.suffix = QStringLiteral(" m");
    format.decimals = 1;
    m_field->setFormat(format);
    m_field->addHandle(m_distanceLabel);
    m_distanceLabel->setBuddy(m_field);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(m_distanceLabel);
    row->addWidget(m_slider, 1);
    row->addWidget(m_field);
    column->addLayout(row);
    connect(m_slider, &NumberSlider::numberEdited, this, &LevelsPanel::setDistance);
    connect(m_field, &NumberField::valueEdited, this, &LevelsPanel::setDistance);
}

void LevelsPanel::buildChoices(QVBoxLayout* column)
{
    m_enlarged = named(new QCheckBox(tr("Zoom to the tree"), m_below), "levelsEnlarged");
    m_enlarged->setChecked(true); // trees are larger than these pictures where levels change
    m_export = named(new QPushButton(tr("Export these levels…"), m_below), "exportTheseLevels");
    auto* row = new QHBoxLayout;
    row->addWidget(m_enlarged);
    row->addStretch(1);
    row->addWidget(m_export);
    column->addLayout(row);
    connect(m_enlarged, &QCheckBox::toggled, this, &LevelsPanel::showShot);
    connect(m_export, &QPushButton::clicked, this, [this] { emit exportRequested(m_watch->options()); });
}

void LevelsPanel::buildPictures(QVBoxLayout* column)
{
    const auto side = [this](QBoxLayout* into, LevelView*& view, QLabel*& text, const char* name) {
        auto* half = new QVBoxLayout;
        half->setSpacing(3);
        view = new LevelView(m_below);
        view->setObjectName(QLatin1String(name));
        text = new QLabel(m_below);
        text->setAlignment(Qt::AlignHCenter);
        text->setWordWrap(true);
        half->addWidget(view, 1);
        half->addWidget(text);
        into->addLayout(half, 1);
    };
    auto* pair = new QHBoxLayout;
    pair->setSpacing(6);
    side(pair, m_levelView, m_levelText, "levelPicture");
    side(pair, m_wholeView, m_wholeText, "wholePicture");
    column->addLayout(pair, 1);
    m_sizeText = named(new QLabel(m_below), "dim");
    m_sizeText->setWordWrap(true);
    column->addWidget(m_sizeText);
}

/// One is turned as the other is.
void LevelsPanel::connectViews()
{
    for (auto [from, to] : {std::pair(m_levelView, m_wholeView), std::pair(m_wholeView, m_levelView)}) {
        connect(from, &LevelView::turned, to, [other = to](double yawRad, double pitchRad) {
            LevelShot shot = other->shot();
            shot.yawRad = yawRad;
            shot.pitchRad = pitchRad;
            other->setShot(shot);
        });
        connect(from, &LevelView::moved, this, [this](double factor) { setDistance(m_distance * factor); });
    }
}

/// Those of the last time, or of the last export for a game; three without budgets at first.
void LevelsPanel::takeStored()
{
    const QVariantMap kept = m_preferences->exportSettings();
    LevelOptions options = gameLevels();
    for (const QString& key : {lastGameKey, storedKey})
        if (const LevelOptions stored = LevelForm::optionsIn(kept.value(key).toMap()); checkLevels(stored))
            options = stored;
    options.distances.clear(); // of a tree of then
    m_form->setOptions(options);
    m_watch->setOptions(options);
}

void LevelsPanel::takeForm()
{
    const auto fine = m_form->check();
    m_formProblem = fine ? QString() : errorText(fine.error());
    m_editProblem.clear();
    if (!fine)
        return follow();
    LevelOptions options = m_form->options();
    options.count = std::max<std::int64_t>(1, options.count); // one without a budget is the tree as it is
    QVariantMap kept = m_preferences->exportSettings();
    LevelOptions anyTree = options;
    anyTree.distances.clear();
    kept.insert(storedKey, LevelForm::settingsOf(anyTree));
    m_preferences->setExportSettings(kept);
    m_watch->setOptions(options);
    follow();
}

/// What is refused leaves the table as it is.
void LevelsPanel::takeEdited(const std::vector<double>& distances, const std::vector<double>& shares)
{
    LevelOptions options = m_form->options();
    options.distances = distances;
    options.shares = shares;
    const auto fine = checkLevels(options);
    m_editProblem = fine ? QString() : errorText(fine.error());
    if (fine)
        m_form->setOptions(options);
    showState();
}

/// Metres suit one tree: another one has its own, or the usual shares. Counts and shares suit all.
void LevelsPanel::takeTree()
{
    const NodeId tree = m_watch->tree();
    if (tree == noNode || tree == m_metresOf)
        return;
    LevelOptions options = m_form->options();
    m_metres[std::exchange(m_metresOf, tree)] = options.distances;
    const auto own = m_metres.find(tree);
    options.distances = own == m_metres.end() ? std::vector<double>() : own->second;
    if (!options.distances.empty()) {
        options.distances.resize(std::size_t(std::max<std::int64_t>(options.total(), 1)) - 1,
                                 options.distances.back());
        options.shares.clear();
    }
    if (options.distances != m_form->options().distances && checkLevels(options))
        m_form->setOptions(options);
}

std::optional<LevelOptions> LevelsPanel::chosen() const
{
    const bool isStored = m_preferences->exportSettings().contains(storedKey);
    return (isStored || m_levels) && m_formProblem.isEmpty() ? std::optional(m_watch->options())
                                                             : std::nullopt;
}

void LevelsPanel::follow()
{
    takeTree();
    const auto levels = m_formProblem.isEmpty() ? m_watch->levels() : nullptr;
    if (levels != m_levels) {
        m_levels = levels;
        takeLevels();
    }
    showState();
}

/// The distance stays where the tree is the same; another one is seen where its second level begins.
void LevelsPanel::takeLevels()
{
    m_shows = true;
    m_model->setLevels(m_levels);
    m_shows = false;
    fitTable();
    m_level.reset();
    m_table->setVisible(m_levels != nullptr);
    m_below->setVisible(m_levels != nullptr);
    if (!m_levels) {
        if (m_watch->tree() == noNode)
            m_tree = noNode;
        return showShot();
    }
    const double filled =
        levelPixels(*m_levels, 1.0) / levelScreenHeight; // m, where the tree fills the screen
    const std::vector<double>& distances = m_levels->switches.distances;
    m_least = roundedDown(std::max(0.7 * filled, 0.01));
    m_most = std::max(100.0 * m_least, roundedDown(2.5 * distances.back()));
    m_slider->setSoftRange(m_least, m_most, 1.0, false);
    m_field->setRange(m_least, m_most);
    m_field->setScale(NumberScale(m_least, m_most, 1.0, false));
    const bool isOther = std::exchange(m_tree, m_watch->tree()) != m_watch->tree();
    setDistance(isOther || m_distance <= 0.0 ? (distances.size() > 1 ? distances[1] : filled) : m_distance);
}

/// As high as its rows: the rest is for the pictures.
void LevelsPanel::fitTable()
{
    const int rows = std::max(1, m_model->rowCount());
    const int row =
        m_model->rowCount() > 0 ? m_table->sizeHintForRow(0) : m_table->fontMetrics().height() + 6;
    const int bar = m_table->horizontalScrollBar()->sizeHint().height();
    m_table->setFixedHeight(m_table->header()->sizeHint().height() + rows * row + bar);
}

void LevelsPanel::setDistance(double metres)
{
    if (!m_levels)
        return;
    const double held = std::clamp(metres, m_least, m_most);
    showLevel(held, m_levels->levelAt(held));
}

/// Where it begins; two that begin at one place are both to be seen there.
void LevelsPanel::showRow(int row)
{
    if (!m_levels)
        return;
    const auto level = static_cast<std::size_t>(row);
    showLevel(std::clamp(m_levels->switches.distances[level], m_least, m_most), level);
}

void LevelsPanel::showLevel(double distance, std::size_t level)
{
    m_distance = distance;
    m_level = level;
    m_slider->setNumber(distance);
    m_field->setValue(distance);
    m_shows = true;
    m_table->setCurrentIndex(m_model->index(static_cast<int>(level), 0));
    m_shows = false;
    showShot();
}

void LevelsPanel::showShot()
{
    LevelShot shot = m_levelView->shot();
    shot.distance = m_distance;
    shot.enlarged = m_enlarged->isChecked();
    m_levelView->setShot(shot);
    m_wholeView->setShot(shot);
    m_levelView->setLevel(m_levels, m_level);
    m_wholeView->setLevel(m_levels, std::nullopt);
    if (!m_levels || !m_level) {
        for (QLabel* text : {m_levelText, m_wholeText, m_sizeText})
            text->clear();
        return;
    }
    const TreeLevel& level = m_levels->levels[*m_level];
    m_levelText->setText(tr("Level %1\n%2 triangles").arg(*m_level).arg(countText(level.triangles())));
    m_wholeText->setText(tr("Whole tree\n%1 triangles").arg(countText(facesOf(m_levels->whole))));
    m_sizeText->setText(
        tr("At %1 the tree is %2 pixels high on a screen of 1080.")
            .arg(metresText(m_distance), countText(std::llround(levelPixels(*m_levels, m_distance)))));
}

void LevelsPanel::showState()
{
    using State = LevelWatch::State;
    const Node* node = m_document->scene().find(m_watch->tree());
    m_pages->setCurrentIndex(node ? 1 : 0);
    m_empty->setText(
        tr("Select a tree: its levels of detail are shown here as a game shows them, before they are "
           "exported."));
    if (!node)
        return;
    m_title->setText(QString::fromStdString(node->name));
    const State state = m_formProblem.isEmpty() ? m_watch->state() : State::Failed;
    const bool runs = state == State::Waiting || state == State::Running;
    QString text;
    if (state == State::Growing || state == State::None)
        text = tr("The tree is growing…");
    else if (state == State::Cancelled)
        text = tr("Cancelled");
    else if (state == State::Failed)
        text = m_formProblem.isEmpty() ? errorText(m_watch->error()) : m_formProblem;
    else if (!m_editProblem.isEmpty())
        text = m_editProblem;
    else if (state == State::Done && m_levels && m_levels->levels.size() > 1)
        text = tr("Double-click a distance or a height to change it.");
    const bool isProblem = state == State::Failed || (!m_editProblem.isEmpty() && text == m_editProblem);
    const QString name = isProblem ? QStringLiteral("problem") : QStringLiteral("dim");
    if (m_state->objectName() != name) {
        m_state->setObjectName(name);
        m_state->style()->unpolish(m_state);
        m_state->style()->polish(m_state); // the theme goes by the name
    }
    m_state->setText(text);
    m_state->setVisible(!runs);
    if (runs && m_progress->isHidden())
        m_progress->setValue(0);
    m_progress->setVisible(runs);
    m_cancel->setVisible(runs);
    m_again->setVisible(state == State::Cancelled);
}

void LevelsPanel::showMenu(const QPoint& at)
{
    const QModelIndex index = m_table->indexAt(at);
    if (!index.isValid() || !m_levels)
        return;
    const int row = index.row();
    const std::int64_t triangles = m_levels->levels[static_cast<std::size_t>(row)].triangles();
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Go to its &distance"), this, [this, row] { showRow(row); });
    menu->addSeparator();
    menu->addAction(icon("copy"), tr("&Copy the figures"), this, [this, row] { copy(row, 1); });
    menu->addAction(tr("Copy the whole &table"), this, [this] { copy(0, m_model->rowCount()); });
    menu->addSeparator();
    menu->addAction(icon("export"), tr("&Export these levels…"), this,
                    [this] { emit exportRequested(m_watch->options()); });
    const bool isTree = row == 0 && m_watch->options().beginsWhole();
    if (!m_levels->levels[static_cast<std::size_t>(row)].billboard)
        menu->addAction(tr("Export a tree of %1 t&riangles alone…").arg(countText(triangles)), this,
                        [this, isTree, triangles] {
                            emit exportRequested(isTree ? LevelOptions{1} : LevelOptions{1, {triangles}});
                        });
    menu->popup(m_table->viewport()->mapToGlobal(at));
}

void LevelsPanel::copy(int firstRow, int count)
{
    QGuiApplication::clipboard()->setText(m_model->text(firstRow, count));
    emit messageRaised(tr("Copied %Ln level(s)", nullptr, count));
}

/// Ctrl+C is of the row here, not of the tree.
bool LevelsPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != m_table ||
        (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress))
        return QWidget::eventFilter(watched, event);
    if (!static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy) || !m_level)
        return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::KeyPress)
        copy(static_cast<int>(*m_level), 1);
    event->accept();
    return true;
}

void LevelsPanel::setSeen(bool seen)
{
    m_watch->setActive(seen && isVisible());
    follow();
}

void LevelsPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    setSeen(true);
}

void LevelsPanel::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    setSeen(false);
}

} // namespace ramure
