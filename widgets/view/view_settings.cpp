#include "widgets/view/view_settings.h"

#include "widgets/view/tools/gizmo_settings.h"
#include "widgets/view/tools/hand_settings.h"

namespace ramure {

ViewSettings::ViewSettings(QObject* parent)
    : QObject(parent)
    , m_gizmo(new GizmoSettings(this))
    , m_hand(new HandSettings(this))
{
    connect(m_hand, &HandSettings::toolChanged, m_gizmo, [this](HandTool tool) {
        if (tool != HandTool::None)
            m_gizmo->tool.set(TransformTool::Select);
    });
    connect(m_gizmo, &GizmoSettings::changed, m_hand, [this] {
        if (m_gizmo->tool() != TransformTool::Select)
            m_hand->setTool(HandTool::None);
    });
}

void ViewSettings::beginDocument()
{
    light.set({});
    gameWind.set(WindProfile::None);
    m_hand->setTool(HandTool::None);
    m_hand->setOptions({});
    m_gizmo->beginDocument();
}

} // namespace ramure
