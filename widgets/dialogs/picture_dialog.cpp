#include "widgets/dialogs/picture_dialog.h"

#include "widgets/base/named.h"
#include "widgets/dialogs/lens_form.h"
#include "widgets/dialogs/picture_form.h"
#include "widgets/view/viewport.h"
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QVBoxLayout>

namespace ramure {

PictureDialog::PictureDialog(QSize pixels, const NodeView& view, const QVariantMap& kept, QWidget* parent)
    : QDialog(parent)
    , m_form(new PictureForm(this))
    , m_grid(new QCheckBox(tr("Grid and axes"), this))
    , m_lens(new LensForm(view, kept, this))
{
    setObjectName(QStringLiteral("pictureDialog"));
    m_grid->setObjectName(QStringLiteral("pictureGrid"));
    auto* layout = layoutOf<QVBoxLayout>(this, 6, {18, 18, 18, 14});
    layout->setSizeConstraint(QLayout::SetMinimumSize);
    layout->addWidget(m_form);
    layout->addWidget(m_grid);
    layout->addSpacing(8);
    layout->addWidget(m_lens);
    layout->addSpacing(8);
    auto* buttons = new QDialogButtonBox(this);
    buttons->addButton(QDialogButtonBox::Save)->setText(tr("Save…"));
    buttons->addButton(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    layout->addWidget(buttons);
    m_form->setViewSize(pixels);
    const QSize size(kept.value(QStringLiteral("width")).toInt(),
                     kept.value(QStringLiteral("pixels")).toInt());
    if (!size.isEmpty())
        m_form->setPictureSize(size);
    m_form->setTransparent(kept.value(QStringLiteral("transparent")).toBool());
    m_grid->setChecked(kept.value(QStringLiteral("grid")).toBool());
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    // Both are parts of the world.
    connect(m_form, &PictureForm::changed, this, [this] { m_grid->setEnabled(!m_form->isTransparent()); });
    m_grid->setEnabled(!m_form->isTransparent());
    setWindowTitle(tr("Save a picture"));
    m_grid->setToolTip(tr("The lines on the ground"));
}

ViewPicture PictureDialog::wish() const
{
    return {m_form->pictureSize(), m_form->isTransparent(), m_grid->isChecked(), m_lens->samples(),
            m_lens->lens()};
}

/// As large as the view stays so when that has another size.
QVariantMap PictureDialog::settings() const
{
    QVariantMap kept = m_lens->settings();
    kept.insert({{"transparent", m_form->isTransparent()}, {"grid", m_grid->isChecked()}});
    if (!m_form->isLikeView())
        kept.insert({{"width", m_form->pictureSize().width()}, {"pixels", m_form->pictureSize().height()}});
    return kept;
}

} // namespace ramure
