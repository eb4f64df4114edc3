#include "widgets/panels/animation/key_panel.h"

#include "core/qt/session/motion/player.h"
#include "widgets/base/empty_page.h"
#include "widgets/base/named.h"
#include "widgets/base/timeline_ruler.h"
#include "widgets/panels/animation/key_actions.h"
#include "widgets/panels/animation/key_curves.h"
#include "widgets/panels/animation/key_sheet.h"
#include "widgets/panels/animation/key_values.h"
#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolButton>

namespace ramure {

KeyPanel::KeyPanel(KeyModel* model, KeyCommands* commands, KeyActions* actions, Player* player,
                   QWidget* parent)
    : QWidget(parent)
    , m_model(model)
    , m_commands(commands)
    , m_actions(actions)
    , m_player(player)
{
    setObjectName(QStringLiteral("keyPanel"));
    buildTools();
    buildSheet();
    auto* layout = layoutOf<QVBoxLayout>(this, 4, {6, 4, 6, 6});
    layout->addWidget(m_tools);
    layout->addWidget(m_pages, 1);
    layout->setSizeConstraint(QLayout::SetNoConstraint); // see minimumSizeHint
    connectAll();
    showTimeline();
    showRows();
    showSelection();
}

QToolButton* KeyPanel::addMenuButton(QMenu* menu, const QString& text, const QString& tip)
{
    auto* button = new QToolButton(m_tools);
    button->setText(text);
    button->setToolTip(tip);
    button->setAutoRaise(true);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setFocusPolicy(Qt::TabFocus);
    button->setMenu(menu);
    m_row->addWidget(button);
    return button;
}

void KeyPanel::buildTools()
{
    m_tools = new QWidget(this);
    auto* rows = layoutOf<QVBoxLayout>(m_tools, 4);
    m_row = new QHBoxLayout;
    m_below = new QHBoxLayout;
    rows->addLayout(m_row);
    rows->addLayout(m_below);
    QHBoxLayout* row = m_row;
    row->setSpacing(2);
    const auto addAction = [this, row](QAction* action) {
        auto* button = new QToolButton(m_tools);
        button->setDefaultAction(action);
        button->setAutoRaise(true);
        button->setIconSize({16, 16});
        button->setFocusPolicy(Qt::TabFocus);
        row->addWidget(button);
        return button;
    };
    auto* insert = addAction(m_actions->insertAction());
    insert->setMenu(m_actions->insertMenu(insert));
    insert->setPopupMode(QToolButton::MenuButtonPopup);
    insert->setMinimumWidth(insert->sizeHint().width() + 16); // the arrow must not cover the picture
    addAction(m_actions->autoAction());
    addAction(m_actions->previousAction());
    addAction(m_actions->nextAction());
    row->addSpacing(6);
    m_modes = addMenuButton(m_actions->modeMenu(m_tools), tr("Mode"),
                            tr("How the value goes from each selected key to the next"));
    m_easings = addMenuButton(m_actions->easingMenu(m_tools), tr("Easing"),
                              tr("At which end the easings of the selected keys show their character"));
    m_handles = addMenuButton(m_actions->handleMenu(m_tools), tr("Handles"),
                              tr("Position of the handles of the selected Bézier keys"));
    m_extrapolations =
        addMenuButton(m_actions->extrapolationMenu(m_tools), tr("Ends"),
                      tr("Values of the channels before their first key and after their last"));
    buildChoices();
    row->addStretch(1);
    m_values = new KeyValues(m_model, m_tools);
    row->addWidget(m_values);
}

/// Snapping, and what the sheet shows.
void KeyPanel::buildChoices()
{
    m_row->addSpacing(6);
    m_snapLabel = new QLabel(tr("Snap to"), m_tools);
    m_snap = new QComboBox(m_tools);
    m_snap->addItems({tr("nothing"), tr("frames"), tr("seconds")});
    m_snap->setCurrentIndex(static_cast<int>(m_commands->snapping()));
    m_snap->setToolTip(tr("Snapping of dragged keys; hold Shift to drag freely"));
    m_snap->setAccessibleName(tr("Snapping"));
    m_snapLabel->setBuddy(m_snap);
    m_row->addWidget(m_snapLabel);
    m_row->addSpacing(4);
    m_row->addWidget(m_snap);
    const auto add = [this](const QString& name, const QString& text, const QString& tip) {
        auto* button = new QToolButton(m_tools);
        button->setObjectName(name);
        button->setText(text);
        button->setToolTip(tip);
        button->setAutoRaise(true);
        button->setCheckable(true);
        button->setFocusPolicy(Qt::TabFocus);
        m_row->addWidget(button);
        return button;
    };
    m_all = add(QStringLiteral("allNodesButton"), tr("All nodes"),
                tr("Show the keys of all nodes, not only of those selected in the scene"));
    m_showCurves = add(QStringLiteral("curvesButton"), tr("Curves"),
                       tr("Show the values over time instead of the dope sheet"));
    m_normalise = add(QStringLiteral("normaliseButton"), tr("Normalise"),
                      tr("Every curve over the same height, whatever its values"));
    m_normalise->hide();
}

/// Languages differ: what has no room goes below, and the words before the list of steps go last of all.
void KeyPanel::arrangeTools()
{
    const int room = m_tools->width();
    const int values = m_values->isHidden() ? 0 : m_values->sizeHint().width() + m_row->spacing();
    m_snapLabel->show();
    int needed = m_row->sizeHint().width() - (m_valuesBelow ? 0 : values);
    if (needed > room) {
        m_snapLabel->hide();
        needed = m_row->sizeHint().width() - (m_valuesBelow ? 0 : values);
    }
    const bool below = needed + values > room;
    if (below == m_valuesBelow)
        return;
    m_valuesBelow = below;
    (below ? m_row : m_below)->removeWidget(m_values);
    (below ? m_below : m_row)->addWidget(m_values, 0, Qt::AlignRight);
}

void KeyPanel::buildSheet()
{
    m_pages = new QStackedWidget(this);
    m_empty = new EmptyPage(m_pages);
    m_empty->setText(
        tr("No keys here. Select a node and press I to insert keys of its position, rotation and "
           "scale at the frame on show."));
    auto* page = new QWidget(m_pages);
    auto* row = layoutOf<QHBoxLayout>(page, 0);
    m_splitter = new QSplitter(page);
    m_splitter->setChildrenCollapsible(false);
    m_scroll = new QScrollBar(page);
    row->addWidget(m_splitter, 1);
    row->addWidget(m_scroll);
    m_ruler = new TimelineRuler(m_splitter);
    const auto column = [this](QWidget* top, QWidget* below) {
        auto* holder = new QWidget(m_splitter);
        auto* layout = layoutOf<QVBoxLayout>(holder, 0);
        layout->addWidget(top);
        layout->addWidget(below, 1);
        m_splitter->addWidget(holder);
    };
    auto* corner = new QWidget(this);
    corner->setFixedHeight(m_ruler->sizeHint().height());
    auto* beside = layoutOf<QHBoxLayout>(corner, -1, {8, 0, 4, 0});
    m_count = named(new QLabel(corner), "dim");
    m_count->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // names decide the width
    beside->addWidget(m_count);
    m_names = new KeyRowList(m_model, m_scroll, m_splitter);
    m_sheet = new KeySheet(m_model, m_commands, m_ruler, m_scroll, m_splitter);
    column(corner, m_names);
    m_views = new QStackedWidget(m_splitter);
    m_curves = new KeyCurves(m_model, m_commands, m_ruler, m_views);
    m_views->addWidget(m_sheet);
    m_views->addWidget(m_curves);
    column(m_ruler, m_views);
    m_splitter->setStretchFactor(0, 0);
    m_splitter->setStretchFactor(1, 1);
    m_splitter->setSizes({190, 800});
    m_pages->addWidget(m_empty);
    m_pages->addWidget(page);
    m_menu = new QMenu(this);
    m_actions->fillMenu(m_menu);
}

void KeyPanel::connectAll()
{
    connect(m_model, &KeyModel::rowsChanged, this, &KeyPanel::showRows);
    connect(m_model, &KeyModel::selectionChanged, this, &KeyPanel::showSelection);
    connect(m_model->document(), &Document::changed, this, [this](const Change& change) {
        if (change.has(changeTimeline | changeReset))
            showTimeline();
    });
    connect(m_player, &Player::frameChanged, this, [this](qint64 frame) {
        m_ruler->setFrame(frame);
        m_sheet->setFrame(frame);
        m_curves->setFrame(frame);
    });
    connect(m_showCurves, &QToolButton::toggled, this, &KeyPanel::setCurvesShown);
    connect(m_normalise, &QToolButton::toggled, m_curves, &KeyCurves::setNormalised);
    connect(m_player, &Player::bandChanged, this, [this] { m_ruler->setBand(m_player->band()); });
    connect(m_ruler, &TimelineRuler::frameSought, m_player, &Player::seek);
    connect(m_names, &KeyRowList::rowClicked, m_sheet, &KeySheet::setCurrentRow);
    connect(m_values, &KeyValues::messageRaised, m_commands, &KeyCommands::messageRaised);
    connect(m_all, &QToolButton::toggled, m_model, &KeyModel::setAllNodes);
    connect(m_snap, &QComboBox::activated, this,
            [this](int index) { m_commands->setSnapping(static_cast<KeySnap>(index)); });
    const auto popUp = [this](const QPoint& place) { m_menu->popup(place); };
    connect(m_sheet, &KeySheet::menuRequested, this, popUp);
    connect(m_curves, &KeyCurves::menuRequested, this, popUp);
}

void KeyPanel::showTimeline()
{
    m_ruler->setTimeline(m_model->timeline());
    m_ruler->setFrame(m_player->frame());
    m_sheet->setFrame(m_player->frame());
    m_curves->setFrame(m_player->frame());
}

void KeyPanel::setCurvesShown(bool shown)
{
    m_showCurves->setChecked(shown);
    m_views->setCurrentIndex(shown ? 1 : 0);
    m_names->setEyes(shown);
    m_model->setCurvesShown(shown);
    m_normalise->setVisible(shown);
    arrangeTools();
    if (shown)
        m_curves->fitAll();
}

void KeyPanel::showRows()
{
    const int rows = int(m_model->rows().size());
    const int room = m_names->height() - KeyRowsView::strip;
    m_scroll->setSingleStep(m_sheet->rowHeight());
    m_scroll->setPageStep(std::max(1, room));
    m_scroll->setRange(0, std::max(0, rows * m_sheet->rowHeight() - room));
    m_scroll->setVisible(m_scroll->maximum() > 0);
    m_pages->setCurrentIndex(rows == 0 ? 0 : 1);
}

void KeyPanel::showSelection()
{
    const auto count = int(keys::count(m_model->selection()));
    m_count->setText(count == 0 ? QString() : tr("%n key(s) selected", nullptr, count));
    m_count->setToolTip(m_count->text());
    for (QToolButton* button : {m_modes, m_easings, m_handles, m_extrapolations})
        button->setEnabled(count > 0);
    arrangeTools();
}

QSize KeyPanel::minimumSizeHint() const
{
    return {420, m_tools->minimumSizeHint().height() + m_ruler->minimumSizeHint().height() +
                     m_sheet->minimumSizeHint().height() + 14};
}

void KeyPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    layout()->activate();
    arrangeTools();
    layout()->activate();
    showRows();
}

} // namespace ramure
