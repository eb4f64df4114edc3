#include "widgets/panels/properties/surface_preview.h"

#include "widgets/panels/properties/surface_pictures.h"
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>

namespace ramure {
namespace {

constexpr int pictureSide = 112; ///< of one picture, device-independent pixels

const char* nameOf(SurfacePreview::Surface surface)
{
    switch (surface) {
    case SurfacePreview::Surface::Leaf:
        return "leafPreview";
    case SurfacePreview::Surface::Fruit:
        return "fruitPreview";
    case SurfacePreview::Surface::Bark:
        return "barkPreview";
    case SurfacePreview::Surface::Object:
        return "objectPreview";
    }
    return "";
}

} // namespace

SurfacePreview::SurfacePreview(Document* document, Surface surface, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_surface(surface)
{
    setObjectName(QLatin1String(nameOf(surface)));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeParams | changeReset | changeStructure))
            refresh();
    });
    if (surface == Surface::Leaf) {
        m_larger = new QToolButton(this);
        m_larger->setObjectName(QStringLiteral("largerLeaf"));
        m_larger->setFocusPolicy(Qt::TabFocus);
        connect(m_larger, &QToolButton::clicked, this, &SurfacePreview::largerRequested);
    }
    setToolTip(m_surface == Surface::Leaf    ? tr("One leaf from above, without its neighbours")
               : m_surface == Surface::Fruit ? tr("One fruit or flower from the side, with its stalk")
               : m_surface == Surface::Bark  ? tr("The bark on a ball, and one tile of it")
                                             : tr("The surface on a ball, and one tile of it"));
    setAccessibleName(toolTip());
    if (m_larger) {
        m_larger->setText(tr("Larger…"));
        m_larger->setToolTip(tr("The leaf and a twig in a window of their own, which the properties shape"));
        placeButton();
    }
}

QSize SurfacePreview::sizeHint() const
{
    const bool isBall = m_surface == Surface::Bark || m_surface == Surface::Object;
    return {isBall ? 2 * pictureSide : pictureSide, pictureSide};
}

void SurfacePreview::setNode(NodeId node)
{
    m_node = node;
    refresh();
}

Material SurfacePreview::materialOf(const Node& node, bool turns) const
{
    const NodeParams& params = node.params;
    switch (m_surface) {
    case Surface::Leaf:
        return leavesMaterial(params.leaf.shape, turns, params.leafPictures);
    case Surface::Fruit:
        return applesMaterial(params.fruit.kind, params.fruitPictures);
    case Surface::Bark:
        return barkMaterial(params.bark, params.barkPictures);
    case Surface::Object:
        break;
    }
    return nodeMaterial(node, params);
}

/// Asks for another picture where what it shows has changed; while nobody sees it, not yet.
void SurfacePreview::refresh()
{
    const Node* node = m_document->scene().find(m_node);
    const bool isTree = node && node->kind == NodeKind::Tree;
    const bool isObject = node && (node->kind == NodeKind::Primitive || node->kind == NodeKind::Mesh);
    setVisible(m_surface == Surface::Object ? isObject : isTree);
    if (!node || !isVisible())
        return;
    const NodeParams& params = node->params;
    const bool turns = params.leaf.season > 0.5;
    const Material material = materialOf(*node, turns);
    if (m_isAsked && m_leaf == params.leaf && m_fruit == params.fruit && m_material == material &&
        m_turns == turns)
        return;
    m_leaf = params.leaf;
    m_fruit = params.fruit;
    m_material = material;
    m_turns = turns;
    m_isAsked = true;
    const int size = static_cast<int>(pictureSide * devicePixelRatioF());
    m_job.start(
        [surface = m_surface, leaf = m_leaf, fruit = m_fruit, material, turns,
         size](const Progress& progress) {
            return Expected<QImage>(surface == Surface::Leaf
                                        ? leafPicture(leaf, turns, size, material.pictures)
                                    : surface == Surface::Fruit ? fruitPicture(fruit, size, material.pictures)
                                                                : barkPicture(material, size, progress));
        },
        [this](Expected<QImage>&& made) {
            if (!made || made->isNull())
                return;
            m_picture = std::move(*made);
            m_picture.setDevicePixelRatio(devicePixelRatioF());
            update();
        });
}

/// In the lower right corner.
void SurfacePreview::placeButton()
{
    if (!m_larger)
        return;
    m_larger->adjustSize();
    m_larger->move(width() - m_larger->width(), height() - m_larger->height());
}

void SurfacePreview::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    placeButton();
}

void SurfacePreview::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (m_larger && event->button() == Qt::LeftButton)
        emit largerRequested();
}

void SurfacePreview::paintEvent(QPaintEvent*)
{
    if (m_picture.isNull())
        return;
    QPainter painter(this);
    const QSizeF shown = m_picture.deviceIndependentSize();
    painter.drawImage(QPointF(0.5 * (width() - shown.width()), 0.5 * (height() - shown.height())), m_picture);
}

void SurfacePreview::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    refresh();
}

} // namespace ramure
