#include "widgets/panels/properties/surface_preview.h"

#include "widgets/panels/properties/surface_pictures.h"
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>

namespace ramure {
namespace {

constexpr int side = 112; ///< of one picture, device-independent pixels

} // namespace

SurfacePreview::SurfacePreview(Document* document, Surface surface, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_surface(surface)
{
    setObjectName(surface == Surface::Leaf   ? QStringLiteral("leafPreview")
                  : surface == Surface::Bark ? QStringLiteral("barkPreview")
                                             : QStringLiteral("objectPreview"));
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
    retranslate();
}

QSize SurfacePreview::sizeHint() const
{
    return {m_surface == Surface::Leaf ? side : 2 * side, side};
}

void SurfacePreview::setNode(NodeId node)
{
    m_node = node;
    refresh();
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
    const Material material = m_surface == Surface::Object ? nodeMaterial(*node, params)
                              : m_surface == Surface::Bark
                                  ? barkMaterial(params.bark, params.barkPictures)
                                  : leavesMaterial(params.leaf.shape, turns, params.leafPictures);
    if (m_isAsked && m_leaf == params.leaf && m_material == material && m_turns == turns)
        return;
    m_leaf = params.leaf;
    m_material = material;
    m_turns = turns;
    m_isAsked = true;
    const int size = static_cast<int>(side * devicePixelRatioF());
    m_job.start(
        [surface = m_surface, leaf = m_leaf, material, turns, size](const Progress& progress) {
            return Expected<QImage>(surface == Surface::Leaf
                                        ? leafPicture(leaf, turns, size, material.pictures)
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

void SurfacePreview::retranslate()
{
    setToolTip(m_surface == Surface::Leaf   ? tr("One leaf from above, without its neighbours")
               : m_surface == Surface::Bark ? tr("The bark on a ball, and one tile of it")
                                            : tr("The surface on a ball, and one tile of it"));
    setAccessibleName(toolTip());
    if (m_larger) {
        m_larger->setText(tr("Larger…"));
        m_larger->setToolTip(tr("The leaf and a twig in a window of their own, which the properties shape"));
        placeButton();
    }
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

void SurfacePreview::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace ramure
