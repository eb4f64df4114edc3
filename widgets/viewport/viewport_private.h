/// \file
/// The state of a viewport, shared by its drawing half (viewport.cpp) and its mouse half
/// (viewport_input.cpp).
#pragma once

#include "core/document/document.h"
#include "widgets/render/renderer.h"
#include "widgets/render/scene_builder.h"
#include "widgets/viewport/background_picker.h"
#include "widgets/viewport/navigation.h"
#include "widgets/viewport/viewport.h"
#include <QTimer>
#include <QVariantAnimation>

namespace ramure {

struct Viewport::Private
{
    Document* document = nullptr;
    ViewSettings* settings = nullptr;

    Camera camera;
    Camera from, to; ///< of the animation
    QVariantAnimation flight;
    bool frameNext = true; ///< the next scene that has something in it is framed

    SceneBuilder builder;
    std::shared_ptr<const RenderScene> scene = std::make_shared<const RenderScene>();
    bool sceneStale = true;
    bool highlightsStale = false;
    InspectedSection inspected;
    NodeId isolatedNode = noNode;
    std::vector<Index> isolatedBranches;
    std::shared_ptr<const LineSet> defectLines;
    std::shared_ptr<const PointSet> defectPoints;

    std::unique_ptr<Renderer> renderer;
    bool software = false;
    QString failure; ///< why there is no renderer
    QMetaObject::Connection contextGone;
    FrameTimes times;

    BackgroundPicker picker;
    QTimer hoverRest;
    QPointF hoverPosition;
    NodeId hoverNode = noNode;
    Index hoverBranch = noIndex;
    std::optional<AxisView> hoverSide; ///< of the navigation cube

    Gesture gesture = Gesture::None;
    Qt::MouseButton button = Qt::NoButton;
    QPointF pressed, last;
    /// A finished click or box that waits for the pick scene of a large tree.
    struct Pending
    {
        QPointF from, to;
        bool isBox = false;
        bool extend = false;
    };
    std::optional<Pending> pending;
    bool dragging = false; ///< the pointer has left the place of the press
    bool onCube = false;   ///< the press was on the navigation cube

    [[nodiscard]] const TreeResult* resultOf(NodeId id) const
    {
        const NodeResult* result = document->result(id);
        return result ? &result->tree : nullptr;
    }
    [[nodiscard]] SceneView sceneView() const;
    [[nodiscard]] RenderOptions options(double pixelRatio) const;
};

} // namespace ramure
