#include "widgets/panels/timeline/timeline_panel.h"

#include "core/qt/document/key_edits.h"
#include "core/qt/session/arm/arm_reach.h"
#include "core/qt/session/motion/player.h"
#include "widgets/base/action_set.h"
#include "widgets/base/fields/number_field.h"
#include "widgets/base/named.h"
#include "widgets/base/silence.h"
#include "widgets/base/timeline_ruler.h"
#include "widgets/panels/timeline/bake_actions.h"
#include "widgets/panels/timeline/physics_plot.h"
#include "widgets/panels/timeline/play_actions.h"
#include "widgets/panels/timeline/ruler_menu.h"
#include "widgets/panels/timeline/time_field.h"
#include <QComboBox>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QProgressBar>
#include <QToolButton>

namespace ramure {
namespace {

NumberFormat plainFormat(const QString& suffix, int decimals)
{
    NumberFormat format;
    format.suffix = suffix;
    format.decimals = decimals;
    return format;
}

QToolButton* toolButton(QAction* action, QWidget* parent)
{
    auto* button = new QToolButton(parent);
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    button->setIconSize({16, 16});
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

} // namespace

TimelinePanel::TimelinePanel(Document* document, Player* player, PlayActions* actions, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_player(player)
    , m_actions(actions)
    , m_ruler(new TimelineRuler(this))
    , m_rulerMenu(new RulerMenu(document, player, actions, this))
    , m_plot(new PhysicsPlot(this))
{
    setObjectName(QStringLiteral("timelinePanel"));
    buildTransport();
    buildSettings();
    m_controls = new QBoxLayout(QBoxLayout::LeftToRight);
    m_controls->setSpacing(4);
    m_controls->addWidget(m_transport, 0, Qt::AlignLeft);
    m_controls->addWidget(m_settings, 0, Qt::AlignLeft);
    m_controls->addStretch(1);
    auto* left = new QVBoxLayout;
    left->setSpacing(4);
    left->addLayout(m_controls);
    left->addWidget(m_ruler);
    left->addStretch(1);
    auto* layout = layoutOf<QHBoxLayout>(this, 8, {6, 4, 6, 6});
    layout->setSizeConstraint(QLayout::SetNoConstraint); // see minimumSizeHint
    layout->addLayout(left, 3);
    layout->addWidget(m_plot, 1);
    connectPlayer();
    m_frame->setToolTip(tr("The moment on show: frames, seconds (\"2 s\") or timecode (\"0:02:00\")"));
    m_first->setToolTip(tr("First frame that is played"));
    m_last->setToolTip(tr("Last frame that is played"));
    m_last->setAccessibleName(m_last->toolTip());
    m_rate->setFormat(plainFormat(tr(" fps"), 2));
    m_rate->setToolTip(tr("Frames per second, 1 to 240"));
    m_rates->setToolTip(tr("Common frame rates"));
    m_speed->setToolTip(tr("How fast time passes while playing, 0.1 to 4 times"));
    m_displays->setToolTip(tr("How moments are shown"));
    m_loop->setToolTip(tr("Behaviour at the last frame"));
    m_cancel->setToolTip(tr("Give up computing; the frame on show stays"));
    m_dropped->setToolTip(tr("Frames that came too late since playing began"));
    // Its room is kept: the text must neither be cut nor move anything while it plays.
    m_dropped->ensurePolished();
    m_dropped->setMinimumWidth(m_dropped->fontMetrics().horizontalAdvance(droppedText(8888)) + 2);
    showSettings();
    showFrame();
    showBusy(false);
}

TimelinePanel::~TimelinePanel()
{
    silenceChildren(this);
}

void TimelinePanel::buildTransport()
{
    m_transport = new QWidget(this);
    auto* row = layoutOf<QHBoxLayout>(m_transport, 1);
    for (QAction* action : m_actions->transport())
        row->addWidget(toolButton(action, m_transport));
    m_loop = named(new QToolButton(m_transport), "loopButton");
    m_loop->setAutoRaise(true);
    m_loop->setIconSize({16, 16});
    m_loop->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(m_loop);
    m_actions->fillLoopMenu(menu);
    m_loop->setMenu(menu);
    row->addWidget(m_loop);
    row->addWidget(toolButton(m_actions->set()->find("play.everyFrame"), m_transport));
    m_frame = named(new TimeField(m_transport), "frameField");
    auto* label = new QLabel(tr("Frame"), m_transport);
    label->setBuddy(m_frame);
    row->addSpacing(8);
    row->addWidget(label);
    row->addSpacing(3);
    row->addWidget(m_frame);
    m_dropped = named(new QLabel(m_transport), "droppedFrames");
    m_progress = new QProgressBar(m_transport);
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    m_progress->setFixedWidth(90);
    m_cancel = new QToolButton(m_transport);
    m_cancel->setAutoRaise(true);
    m_cancel->setIcon(QIcon::fromTheme(QStringLiteral("ramure-cancel")));
    row->addSpacing(6);
    row->addWidget(m_progress);
    row->addWidget(m_cancel);
    row->addWidget(m_dropped);
}

/// Behind "every frame": all that says how frames come about stands together.
void TimelinePanel::setBakeActions(BakeActions* actions)
{
    auto* row = qobject_cast<QHBoxLayout*>(m_transport->layout());
    row->insertWidget(int(m_actions->transport().size()) + 2, actions->makeButton(m_transport));
    m_rulerMenu->addBake(actions);
}

void TimelinePanel::buildSettings()
{
    m_settings = new QWidget(this);
    auto* row = layoutOf<QHBoxLayout>(m_settings, 4);
    m_first = named(new TimeField(m_settings), "firstFrameField");
    m_last = named(new TimeField(m_settings), "lastFrameField");
    m_rate = named(new NumberField(m_settings), "frameRateField");
    m_rate->setRange(leastFrameRate, mostFrameRate);
    m_rate->setStep(1.0);
    connect(m_rate, &NumberField::gestureBegan, this, [this] { m_rateGesture = newGesture(); });
    connect(m_rate, &NumberField::gestureEnded, this, [this] { m_rateGesture = 0; });
    m_rates = new QToolButton(m_settings);
    m_rates->setAutoRaise(true);
    m_rates->setArrowType(Qt::DownArrow);
    m_rates->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(m_rates);
    for (const double rate : {24.0, 25.0, 30.0, 60.0}) {
        QAction* choice = menu->addAction(QLocale().toString(rate));
        connect(choice, &QAction::triggered, this, [this, rate] {
            TimelineSettings settings = m_document->scene().timeline();
            settings.framesPerSecond = rate;
            apply(settings);
        });
    }
    m_rates->setMenu(menu);
    m_speed = named(new NumberField(m_settings), "speedField");
    m_speed->setFormat(plainFormat(QStringLiteral(" ×"), 1));
    m_speed->setRange(Player::leastSpeed, Player::mostSpeed);
    m_speed->setStep(0.1);
    m_displays = new QComboBox(m_settings);
    m_displays->addItems({tr("Frames"), tr("Seconds"), tr("Timecode")});
    const auto add = [&](const QString& text, QWidget* field) {
        auto* label = new QLabel(text, m_settings);
        label->setBuddy(field);
        row->addWidget(label);
        row->addWidget(field);
    };
    add(tr("Range"), m_first);
    row->addWidget(new QLabel(QStringLiteral("–"), m_settings));
    row->addWidget(m_last);
    row->addSpacing(6);
    add(tr("Rate"), m_rate);
    row->addWidget(m_rates);
    row->addSpacing(6);
    add(tr("Speed"), m_speed);
    row->addSpacing(6);
    row->addWidget(m_displays);
}

void TimelinePanel::connectPlayer()
{
    connect(m_ruler, &TimelineRuler::frameSought, m_player, &Player::seek);
    connect(m_ruler, &TimelineRuler::menuRequested, this,
            [this](const QPoint& place, qint64 frame) { m_rulerMenu->popUp(m_ruler, place, frame); });
    connect(m_rulerMenu, &RulerMenu::displayChosen, this, &TimelinePanel::setDisplay);
    connect(m_ruler, &TimelineRuler::rangeDragged, this, [this](qint64 first, qint64 last, bool begins) {
        if (begins)
            m_rangeGesture = newGesture();
        TimelineSettings settings = m_document->scene().timeline();
        settings.firstFrame = first;
        settings.lastFrame = last;
        apply(settings, m_rangeGesture);
    });
    connect(m_frame, &TimeField::frameEdited, m_player, &Player::seek);
    connect(m_first, &TimeField::frameEdited, this, [this](qint64 frame) {
        TimelineSettings settings = m_document->scene().timeline();
        settings.firstFrame = frame;
        settings.lastFrame = std::max<std::int64_t>(settings.lastFrame, frame);
        apply(settings);
    });
    connect(m_last, &TimeField::frameEdited, this, [this](qint64 frame) {
        TimelineSettings settings = m_document->scene().timeline();
        settings.lastFrame = frame;
        settings.firstFrame = std::min<std::int64_t>(settings.firstFrame, frame);
        apply(settings);
    });
    connect(m_rate, &NumberField::valueEdited, this, [this](double rate) {
        TimelineSettings settings = m_document->scene().timeline();
        settings.framesPerSecond = rate;
        apply(settings, m_rateGesture);
    });
    connect(m_rate, &NumberField::refused, this, &TimelinePanel::messageRaised);
    connect(m_speed, &NumberField::refused, this, &TimelinePanel::messageRaised);
    connect(m_speed, &NumberField::valueEdited, m_player, &Player::setSpeed);
    connect(m_displays, &QComboBox::activated, this,
            [this](int index) { setDisplay(static_cast<TimeDisplay>(index)); });
    connect(m_cancel, &QToolButton::clicked, m_player, &Player::cancel);
    connect(m_player, &Player::frameChanged, this, &TimelinePanel::showFrame);
    connect(m_player, &Player::playingChanged, this, &TimelinePanel::showFrame);
    connect(m_player, &Player::bandChanged, this, [this] { m_ruler->setBand(m_player->band()); });
    connect(m_player, &Player::motionChanged, this, [this] {
        m_plot->add(*m_player->motion());
        showResiduals();
    });
    connect(m_player, &Player::settingsChanged, this, &TimelinePanel::showSettings);
    connect(m_player, &Player::busyChanged, this, &TimelinePanel::showBusy);
    connect(m_player, &Player::progress, this,
            [this](double fraction) { m_progress->setValue(int(1000.0 * fraction)); });
    followDocument();
}

void TimelinePanel::followDocument()
{
    connect(m_document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeTimeline | changeReset))
            showSettings();
        if (change.has(changeReset | changeTracks | changeSelection | changeStructure | changeTimeline))
            showKeys();
        if (change.has(changeReset))
            m_plot->clear();
        if (change.has(changeReset | changeStructure))
            choosePlot();
        if (change.has(changeReset | changeStructure | changeParams | changeJoints | changeNodeState))
            showResiduals();
    });
    showKeys();
    choosePlot();
    showResiduals();
}

/// Of what is selected; of everything where nothing is.
void TimelinePanel::showKeys()
{
    const Scene& scene = m_document->scene();
    std::vector<NodeId> nodes = m_document->selection().nodes;
    if (nodes.empty())
        for (const Node& node : scene.nodes())
            nodes.push_back(node.id);
    std::vector<double> frames;
    for (const Ticks time : keys::timesOf(scene, nodes))
        frames.push_back(secondsOf(time) * scene.timeline().framesPerSecond);
    m_ruler->setKeys(std::move(frames));
}

void TimelinePanel::setReach(ArmReach* reach)
{
    m_reach = reach;
    connect(reach, &ArmReach::moved, this, &TimelinePanel::showResiduals);
}

void TimelinePanel::showResiduals()
{
    if (m_plot->content() == PhysicsPlot::Content::Arms)
        m_plot->setResiduals(armResiduals(m_document->scene(), *m_player, m_reach));
}

/// The plot shows what the scene has to move; without trees and arms there is none.
void TimelinePanel::choosePlot()
{
    const auto has = [nodes = m_document->scene().nodes()](NodeKind kind) {
        return std::any_of(nodes.begin(), nodes.end(),
                           [kind](const Node& node) { return node.kind == kind; });
    };
    m_plot->setContent(has(NodeKind::Tree)  ? PhysicsPlot::Content::Trees
                       : has(NodeKind::Arm) ? PhysicsPlot::Content::Arms
                                            : PhysicsPlot::Content::Nothing);
    arrange();
}

void TimelinePanel::apply(const TimelineSettings& settings, GestureId gesture)
{
    edit::setTimeline(*m_document, settings, gesture);
    showSettings(); // a refused value gives way to the one in force
}

void TimelinePanel::setDisplay(TimeDisplay display)
{
    m_displays->setCurrentIndex(static_cast<int>(display));
    m_rulerMenu->setDisplay(display);
    if (display == m_display)
        return;
    m_display = display;
    showSettings();
    emit displayChanged(display);
}

void TimelinePanel::showSettings()
{
    const TimelineSettings& settings = m_document->scene().timeline();
    m_ruler->setTimeline(settings);
    m_ruler->setDisplay(m_display);
    for (TimeField* field : {m_frame, m_first, m_last})
        field->setDisplay(m_display, settings.framesPerSecond);
    m_first->setFrame(settings.firstFrame);
    m_last->setFrame(settings.lastFrame);
    m_rate->setValue(settings.framesPerSecond);
    m_speed->setValue(m_player->speed());
    QAction* loop = m_actions->loops()[static_cast<qsizetype>(settings.loop)];
    m_loop->setIcon(loop->icon());
    showFrame();
}

void TimelinePanel::showFrame()
{
    m_ruler->setFrame(m_player->frame());
    m_frame->setFrame(m_player->frame());
    const bool drops = m_player->isPlaying() && m_player->droppedFrames() > 0;
    m_dropped->setText(drops ? droppedText(m_player->droppedFrames()) : QString());
}

QString TimelinePanel::droppedText(std::int64_t frames)
{
    return tr("%n frame(s) dropped", nullptr, int(frames));
}

/// Only what takes long shows that it does.
void TimelinePanel::showBusy(bool busy)
{
    const bool shown = busy && !m_player->isPlaying();
    m_progress->setValue(0);
    m_progress->setVisible(shown);
    m_cancel->setVisible(shown);
}

/// In a narrow window the controls take two lines, and the plot gives way: the panels beside are not
/// squeezed.
void TimelinePanel::arrange()
{
    const int transport = m_transport->sizeHint().width(), settings = m_settings->sizeHint().width();
    const int plot = m_plot->sizeHint().width() + 30;
    const bool oneLine = width() >= transport + settings + plot;
    m_controls->setDirection(oneLine ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_plot->setVisible(m_plot->content() != PhysicsPlot::Content::Nothing &&
                       width() >= (oneLine ? transport + settings : std::max(transport, settings)) + plot);
    updateGeometry();
}

QSize TimelinePanel::minimumSizeHint() const
{
    const QSize transport = m_transport->minimumSizeHint(), settings = m_settings->minimumSizeHint();
    const int lines = m_controls->direction() == QBoxLayout::LeftToRight ? 1 : 2;
    return {std::max(transport.width(), settings.width()) + 16,
            lines * (std::max(transport.height(), settings.height()) + 4) +
                m_ruler->minimumSizeHint().height() + 12};
}

void TimelinePanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    arrange();
}

} // namespace ramure
