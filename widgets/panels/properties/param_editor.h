/// \file
/// What every editor of one parameter can do; which one a row gets is decided in param_editor_factory.h.
#pragma once

#include "core/params/param_def.h"
#include "core/qt/document/commands.h"
#include "widgets/base/texts/number_format.h"
#include <QWidget>
#include <optional>
#include <span>

namespace ramure {

/// The value that all have, or nothing where they differ.
std::optional<ParamValue> commonValue(std::span<const ParamValue> values);

class ParamEditor : public QWidget
{
    Q_OBJECT
public:
    ParamEditor(const ParamDef& def, QWidget* parent);

    [[nodiscard]] const ParamDef& def() const { return m_def; }
    /// Returns the parameter's name in the interface's language.
    [[nodiscard]] QString name() const;
    /// Shows the values of the selected nodes, one each, and never emits.
    virtual void showValues(std::span<const ParamValue> values) = 0;
    /// What a reset gives, where it is the same for all selected nodes.
    virtual void setStandard(const std::optional<ParamValue>& value);
    /// Marks the place of an error of the computation inside the editor, where it can.
    virtual void showProblem(const std::optional<Error>& error);
    /// What a text of a grammar is read with: its language, and the names that there are.
    virtual void showGrammar(const GrammarParams& grammar);
    virtual void setAngleUnit(AngleUnit unit);
    /// Dragging the parameter's label drags its number, where it is one.
    virtual void addHandle(QWidget* label);
    /// Says what is wrong inside the editor, where there is room for it; false: the row has to say it.
    virtual bool showMessage(const QString& text);
    /// An editor that wants the whole width, below its label.
    [[nodiscard]] virtual bool isWide() const { return false; }

signals:
    /// The user gave a value, for all nodes. Edits with one gesture are one undo step.
    void valueEdited(const ramure::ParamValue& value, ramure::GestureId gesture);
    /// The user gave one component of a vector, for all nodes; the other components stay as each node has
    /// them.
    void componentEdited(int axis, double value, ramure::GestureId gesture);
    /// What was typed cannot be a value; empty: all is well again.
    void refused(const QString& reason);
    /// What was typed lies outside the range: which end was taken instead; empty: no longer so.
    void held(const QString& note);

protected:
    /// A press, a release, the focus coming or going: what follows is another undo step.
    void nextGesture();
    void emitEdit(const ParamValue& value);
    void emitComponent(int axis, double value);
    void emitSingleEdit(const ParamValue& value); ///< never merged

private:
    const ParamDef& m_def;
    GestureId m_gesture = 0;
};

} // namespace ramure
