#include "widgets/panels/properties/surface_preview.h"

#include "widgets/panels/properties/surface_pictures.h"
#include <QEvent>
#include <QPainter>

namespace ramure {
namespace {

constexpr int side = 112; ///< of one picture, device-independent pixels

} // namespace

SurfacePreview::SurfacePreview(Document* document, Surface surface, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_surface(surface)
{
    setObjectName(surface == Surface::Leaf ? QStringLiteral("leafPreview") : QStringLiteral("barkPreview"));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeParams | changeReset | changeStructure))
            refresh();
    });
    retranslate();
}

QSize SurfacePreview::sizeHint() const
{
    return {m_surface == Surface::Leaf ? side : 2 * side, side};
}

void SurfacePreview::setTree(NodeId tree)
{
    m_tree = tree;
    refresh();
}

/// Asks for another picture where what it shows has changed; while nobody sees it, not yet.
void SurfacePreview::refresh()
{
    const Node* node = m_document->scene().find(m_tree);
    setVisible(node && node->kind == NodeKind::Tree);
    if (!node || !isVisible())
        return;
    const NodeParams& params = node->params;
    const bool turns = params.leaf.season > 0.5;
    if (m_isAsked && m_leaf == params.leaf && m_bark == params.bark && m_turns == turns)
        return;
    m_leaf = params.leaf;
    m_bark = params.bark;
    m_turns = turns;
    m_isAsked = true;
    const int size = static_cast<int>(side * devicePixelRatioF());
    m_job.start(
        [surface = m_surface, leaf = m_leaf, bark = m_bark, turns, size](const Progress& progress) {
            return Expected<QImage>(surface == Surface::Leaf ? leafPicture(leaf, turns, size)
                                                             : barkPicture(bark, size, progress));
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
    setToolTip(m_surface == Surface::Leaf ? tr("One leaf from above, without its neighbours")
                                          : tr("The bark on a ball, and one tile of it"));
    setAccessibleName(toolTip());
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
