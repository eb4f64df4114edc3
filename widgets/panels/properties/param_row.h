/// \file
/// One parameter in the panel: label, editor, reset arrow, and a line for errors.
#pragma once

#include "core/qt/document/key_state.h"
#include "widgets/panels/properties/param_editor.h"

class QLabel;
class QToolButton;

namespace ramure {

class ParamRow : public QWidget
{
    Q_OBJECT
public:
    ParamRow(const ParamDef& def, QWidget* parent);

    [[nodiscard]] const ParamDef& def() const { return m_editor->def(); }
    [[nodiscard]] ParamEditor* editor() const { return m_editor; }
    [[nodiscard]] QToolButton* resetButton() const { return m_reset; }
    /// The message below the editor, empty where all is well.
    [[nodiscard]] QString message() const;

    /// Shows the values of the selected nodes, one each. The presets that they came from tell a reset's
    /// values (core/presets/presets.h).
    void showValues(std::span<const ParamValue> values, std::span<const std::string> presets);
    /// The error of the computation that concerns this parameter.
    void showProblem(const std::optional<Error>& error);
    /// Why the last value was not taken; empty: it was.
    void showRefusal(const QString& reason);
    /// The button for keys; null where the parameter cannot have any. Hidden until a state is shown.
    [[nodiscard]] QToolButton* keyButton() const { return m_key; }
    void showKeyState(KeyState state);
    void setAngleUnit(AngleUnit unit);
    void setLabelWidth(int width);
    /// Something more about this parameter, below its editor and message; the row owns it.
    void addBelow(QWidget* widget);
    [[nodiscard]] int labelWidth() const;
    /// \param words lower case; true where label, tooltip, group and key together hold all of them.
    [[nodiscard]] bool matches(const QStringList& words) const;
    /// True if the name alone contains all words.
    [[nodiscard]] bool isCalled(const QStringList& words) const;
    [[nodiscard]] bool isChanged() const { return m_changed; }
    /// Whether the choices of all nodes use it (core/params/param_relevance.h). The panel hides other rows.
    [[nodiscard]] bool isRelevant() const { return m_relevant; }
    void setRelevant(bool relevant) { m_relevant = relevant; }
    /// Whether an edit would change any of the nodes. A row that does not act is grey and takes no values.
    [[nodiscard]] bool acts() const { return m_acts; }
    void setActs(bool acts);

signals:
    void resetRequested();
    void keyToggled();
    /// A right click on the row; \p at on the screen.
    void menuRequested(const QPoint& at);

protected:
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void showToolTips();
    void showMessage();

    QLabel* m_label = nullptr;
    ParamEditor* m_editor = nullptr;
    QToolButton* m_reset = nullptr;
    QToolButton* m_key = nullptr;
    QLabel* m_meaning = nullptr; ///< below the editor; null where numbers say all themselves (paramMeaning)
    QLabel* m_message = nullptr;
    std::optional<Error> m_problem;
    QString m_refusal;
    AngleUnit m_angleUnit = AngleUnit::Degrees;
    std::string m_preset; ///< preset of all selected nodes, or empty
    bool m_changed = false;
    bool m_relevant = true;
    bool m_acts = true;
};

/// Returns the tooltip of a parameter: its effect, unit, range, default, the value in \p preset, key. Rich
/// text.
QString paramToolTip(const ParamDef& def, AngleUnit unit, const std::string& preset = {});

} // namespace ramure
