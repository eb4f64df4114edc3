/// \file
/// The strip over the view: which tool is chosen, its options, what it does. Options that it has no room for
/// open with the button at its end.
#pragma once

#include "widgets/view/tools/hand_settings.h"
#include <QWidget>
#include <vector>

class QAction;
class QFrame;
class QGridLayout;
class QHBoxLayout;
class QLabel;
class QToolBar;
class QToolButton;

namespace ramure {

class NumberField;
class ViewSettings;

class ToolStrip : public QWidget
{
    Q_OBJECT
public:
    /// \param tools all actions of the tool bar, one of which is checked. \param transforms what the tools
    /// that move nodes have: shown with them. Nothing is owned but \p transforms.
    ToolStrip(ViewSettings* settings, QList<QAction*> tools, QToolBar* transforms, QWidget* parent);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    /// An option of some tools.
    struct Option
    {
        quint32 tools; ///< toolBit
        QWidget* widget;
        QLabel* label; ///< beside it; null: it has its own
        const char* text;
        const char* tip;
        bool HandOptions::*where = nullptr; ///< HandNumber::where
    };
    void addNumbers();
    void addFlags();
    void addChoices();
    void add(const Option& option, const char* id);
    void addMore();
    void follow();     ///< the tool
    void place();      ///< its options: in the strip, as many as there is room for
    void putOptions(); ///< where place() wants them
    void takeValues(); ///< of the options
    void elide();

    HandSettings* m_settings;
    QList<QAction*> m_tools;
    QToolBar* m_transforms;
    QHBoxLayout* m_row = nullptr;
    QLabel* m_icon;
    QLabel* m_name;
    QLabel* m_tip;
    QString m_tipText;
    QToolButton* m_more = nullptr;
    QFrame* m_rest = nullptr; ///< opens at m_more
    QGridLayout* m_restGrid = nullptr;
    std::vector<Option> m_options;
    std::vector<const Option*> m_inStrip, m_inRest;
    std::vector<NumberField*> m_numbers; ///< in the order of handNumbers(), then of handCounts()
};

} // namespace ramure
