#include "widgets/panels/properties/param_editor_factory.h"

#include "widgets/panels/properties/bool_editor.h"
#include "widgets/panels/properties/choice_editor.h"
#include "widgets/panels/properties/color_editor.h"
#include "widgets/panels/properties/grammar_editor.h"
#include "widgets/panels/properties/number_editor.h"
#include "widgets/panels/properties/picture_editor.h"
#include "widgets/panels/properties/profile_editor.h"
#include "widgets/panels/properties/text_editor.h"
#include "widgets/panels/properties/vector_editor.h"

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
    if (def.flags & paramPicture)
        return new PictureEditor(def, parent);
    if (def.flags & paramProfile)
        return new ProfileEditor(def, parent);
    return new TextEditor(def, parent);
}

} // namespace ramure
