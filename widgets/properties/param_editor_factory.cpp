#include "widgets/properties/param_editor_factory.h"

#include "widgets/properties/bool_editor.h"
#include "widgets/properties/choice_editor.h"
#include "widgets/properties/color_editor.h"
#include "widgets/properties/grammar_editor.h"
#include "widgets/properties/number_editor.h"
#include "widgets/properties/text_editor.h"
#include "widgets/properties/vector_editor.h"

namespace ramure {

ParamEditor* makeParamEditor(const ParamDef& def, QWidget* parent)
{
    switch (def.type) {
    case ParamType::Bool:
        return new BoolEditor(def, parent);
    case ParamType::Int:
    case ParamType::Real:
        return new NumberEditor(def, parent);
    case ParamType::Vec3:
        if (def.flags & paramColor)
            return new ColorEditor(def, parent);
        return new VectorEditor(def, parent);
    case ParamType::Enum:
        return new ChoiceEditor(def, parent);
    case ParamType::Text:
        break;
    }
    if (def.flags & (paramGrammar | paramMultiline))
        return new GrammarEditor(def, parent);
    return new TextEditor(def, parent);
}

} // namespace ramure
