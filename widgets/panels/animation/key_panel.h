/// \file
/// The dock of keys: tool buttons, the column of names, ruler and dope sheet.
#pragma once

#include <QWidget>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QMenu;
class QScrollBar;
class QSplitter;
class QStackedWidget;
class QToolButton;

namespace ramure {

class EmptyPage;
class KeyActions;
class KeyCommands;
class KeyCurves;
class KeyModel;
class KeyRowList;
class KeySheet;
class KeyValues;
class Player;
class TimelineRuler;

class KeyPanel : public QWidget
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the panel.
    KeyPanel(KeyModel* model, KeyCommands* commands, KeyActions* actions, Player* player,
             QWidget* parent = nullptr);

    [[nodiscard]] TimelineRuler* ruler() const { return m_ruler; }
    [[nodiscard]] KeySheet* sheet() const { return m_sheet; }
    [[nodiscard]] KeyCurves* curves() const { return m_curves; }
    void setCurvesShown(bool shown);
    [[nodiscard]] KeyValues* values() const { return m_values; }
    [[nodiscard]] KeyRowList* names() const { return m_names; }
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void buildTools();
    void buildSheet();
    void connectAll();
    void arrangeTools();
    QToolButton* addMenuButton(QMenu* menu, const QString& text, const QString& tip);
    void buildChoices();
    void showTimeline();
    void showRows();
    void showSelection();

    KeyModel* m_model;
    KeyCommands* m_commands;
    KeyActions* m_actions;
    Player* m_player;
    QWidget* m_tools = nullptr;
    QHBoxLayout* m_row = nullptr;   ///< row of the tools
    QHBoxLayout* m_below = nullptr; ///< the values, where the row has no room for them
    bool m_valuesBelow = false;
    QToolButton* m_modes = nullptr;
    QToolButton* m_easings = nullptr;
    QToolButton* m_handles = nullptr;
    QToolButton* m_extrapolations = nullptr;
    QToolButton* m_all = nullptr;
    QToolButton* m_showCurves = nullptr;
    QToolButton* m_normalise = nullptr;
    QLabel* m_snapLabel = nullptr;
    QComboBox* m_snap = nullptr;
    KeyValues* m_values = nullptr;
    QLabel* m_count = nullptr;
    QStackedWidget* m_pages = nullptr;
    EmptyPage* m_empty = nullptr;
    QSplitter* m_splitter = nullptr;
    QScrollBar* m_scroll = nullptr;
    TimelineRuler* m_ruler = nullptr;
    KeyRowList* m_names = nullptr;
    KeySheet* m_sheet = nullptr;
    KeyCurves* m_curves = nullptr;
    QStackedWidget* m_views = nullptr;
    QMenu* m_menu = nullptr;
};

} // namespace ramure
