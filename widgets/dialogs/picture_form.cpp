#include "widgets/dialogs/picture_form.h"

#include "widgets/base/named.h"
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>

namespace ramure {

static constexpr int leastSide = 16, mostSide = 8192;
static constexpr QSize usualSizes[] = {{1280, 720}, {1920, 1080}, {2560, 1440}, {3840, 2160}, {1080, 1080}};

PictureForm::PictureForm(QWidget* parent)
    : QWidget(parent)
    , m_width(named(new QSpinBox(this), "pictureWidth"))
    , m_height(named(new QSpinBox(this), "pictureHeight"))
    , m_sizes(new QComboBox(this))
    , m_locked(named(new QCheckBox(tr("Keep the view's ratio"), this), "pictureLocked"))
    , m_transparent(named(new QCheckBox(tr("Transparent background"), this), "pictureTransparent"))
{
    auto* times = new QLabel(QStringLiteral("×"), this);
    for (QSpinBox* box : {m_width, m_height}) {
        box->setRange(leastSide, mostSide);
        connect(box, &QSpinBox::valueChanged, this, [this, box] {
            keepRatio(box);
            emit changed();
        });
    }
    m_height->setSuffix(QStringLiteral(" px"));
    m_sizes->addItem(tr("Own size"));
    for (const QSize& size : usualSizes)
        m_sizes->addItem(QStringLiteral("%1 × %2").arg(size.width()).arg(size.height()), size);
    setPictureSize({1920, 1080});
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(m_width);
    row->addWidget(times);
    row->addWidget(m_height);
    row->addSpacing(8);
    row->addWidget(m_sizes);
    row->addStretch(1);
    auto* column = layoutOf<QVBoxLayout>(this, 6);
    column->addLayout(row);
    column->addWidget(m_locked);
    column->addWidget(m_transparent);
    m_locked->hide();
    connect(m_locked, &QCheckBox::toggled, this, [this] { keepRatio(m_width); });
    connect(m_sizes, &QComboBox::activated, this, [this](int index) {
        if (const QSize size = m_sizes->itemData(index).toSize(); size.isValid())
            setPictureSize(size);
    });
    connect(this, &PictureForm::changed, this,
            [this] { m_sizes->setCurrentIndex(std::max(0, m_sizes->findData(pictureSize()))); });
    connect(m_transparent, &QCheckBox::toggled, this, &PictureForm::changed);
    setFocusProxy(m_width);
    m_width->setToolTip(tr("Width of the pictures in pixels, 16 to 8192"));
    m_height->setToolTip(tr("Height of the pictures in pixels, 16 to 8192"));
    m_width->setAccessibleName(tr("Width"));
    m_height->setAccessibleName(tr("Height"));
    m_sizes->setToolTip(tr("Common sizes"));
    m_sizes->setAccessibleName(tr("Common sizes"));
    m_locked->setToolTip(tr("Keeps the ratio of the view, so that the picture shows the same part of the "
                            "scene. If off, it shows more or less at its sides"));
    m_transparent->setToolTip(tr("Leaves out sky and ground, to put the trees in front of another picture"));
    emit changed();
}

void PictureForm::setMayBeTransparent(bool may)
{
    m_transparent->setEnabled(may);
}

void PictureForm::setViewSize(QSize pixels)
{
    m_viewSize = pixels.boundedTo({mostSide, mostSide}).expandedTo({leastSide, leastSide});
    m_sizes->insertItem(1, tr("As the view, %1 × %2").arg(m_viewSize.width()).arg(m_viewSize.height()),
                        m_viewSize);
    m_locked->show();
    setPictureSize(m_viewSize);
    m_locked->setChecked(true);
}

bool PictureForm::isLikeView() const
{
    return pictureSize() == m_viewSize;
}

/// Of the two sides the other one follows.
void PictureForm::keepRatio(QSpinBox* edited)
{
    if (!m_locked->isChecked() || m_viewSize.isEmpty())
        return;
    const double ratio = double(m_viewSize.width()) / m_viewSize.height();
    QSpinBox* other = edited == m_width ? m_height : m_width;
    const QSignalBlocker once(other);
    other->setValue(qRound(edited == m_width ? edited->value() / ratio : edited->value() * ratio));
}

/// A ratio that is not the view's is no longer kept.
void PictureForm::setPictureSize(QSize pixels)
{
    if (const QSize view = m_viewSize; !view.isEmpty()) {
        const QSize fitting(pixels.width(), qRound(double(pixels.width()) * view.height() / view.width()));
        m_locked->setChecked(m_locked->isChecked() && fitting == pixels);
    }
    m_width->setValue(pixels.width());
    m_height->setValue(pixels.height());
}

QSize PictureForm::pictureSize() const
{
    return {m_width->value(), m_height->value()};
}

bool PictureForm::isTransparent() const
{
    return m_transparent->isEnabled() && m_transparent->isChecked();
}

void PictureForm::setTransparent(bool transparent)
{
    m_transparent->setChecked(transparent);
}

} // namespace ramure
