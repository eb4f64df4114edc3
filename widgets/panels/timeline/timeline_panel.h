/// \file
/// The timeline: transport, ruler with band and playhead, the frame on show, frame rate, range, speed, and a
/// small plot of the physics.
#pragma once

#include "core/qt/document/commands.h"
#include "widgets/base/texts/time_text.h"
#include <QPointer>
#include <QWidget>

class QBoxLayout;
class QComboBox;
class QLabel;
class QProgressBar;
class QToolButton;

namespace ramure {

class NumberField;
class BakeActions;
class ArmReach;
class PhysicsPlot;
class PlayActions;
class Player;
class RulerMenu;
class TimeField;
class TimelineRuler;

class TimelinePanel : public QWidget
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the panel.
    TimelinePanel(Document* document, Player* player, PlayActions* actions, QWidget* parent = nullptr);
    ~TimelinePanel() override;
    /// Adds the button that bakes.
    void setBakeActions(BakeActions* actions);
    /// Arms on their way while nothing plays. Not owned.
    void setReach(ArmReach* reach);

    [[nodiscard]] TimelineRuler* ruler() const { return m_ruler; }
    /// The context menu that this ruler shares with that of the keys.
    [[nodiscard]] RulerMenu* rulerMenu() const { return m_rulerMenu; }
    [[nodiscard]] TimeDisplay display() const { return m_display; }
    void setDisplay(TimeDisplay display);
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void displayChanged(ramure::TimeDisplay display);
    void messageRaised(const QString& text);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void buildTransport();
    void buildSettings();
    void connectPlayer();
    void followDocument();
    void showSettings();
    void showKeys();
    void showFrame();
    [[nodiscard]] static QString droppedText(std::int64_t frames);
    void showBusy(bool busy);
    void apply(const TimelineSettings& settings, GestureId gesture = 0);
    void arrange();
    void choosePlot();
    void showResiduals();

    Document* m_document;
    Player* m_player;
    PlayActions* m_actions;
    TimeDisplay m_display = TimeDisplay::Frames;
    GestureId m_rangeGesture = 0, m_rateGesture = 0;
    TimelineRuler* m_ruler;
    RulerMenu* m_rulerMenu;
    PhysicsPlot* m_plot;
    QPointer<ArmReach> m_reach;
    TimeField* m_frame;
    TimeField* m_first;
    TimeField* m_last;
    NumberField* m_rate;
    NumberField* m_speed;
    QToolButton* m_rates;
    QToolButton* m_loop;
    QComboBox* m_displays;
    QLabel* m_dropped;
    QProgressBar* m_progress;
    QToolButton* m_cancel;
    QBoxLayout* m_controls;
    QWidget* m_transport;
    QWidget* m_settings;
};

} // namespace ramure
