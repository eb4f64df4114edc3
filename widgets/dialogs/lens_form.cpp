#include "widgets/dialogs/lens_form.h"

#include "widgets/base/named.h"
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLocale>
#include <QPushButton>
#include <QSpinBox>
#include <algorithm>

namespace ramure {
namespace {

constexpr int mostSamples = 256;
constexpr double usualFStop = 2.8, mostMetres = 1e6;

void addRow(QFormLayout* form, const QString& text, QWidget* field)
{
    form->addRow(text, field);
    field->setAccessibleName(QString(text).remove(u'&'));
}

} // namespace

LensForm::LensForm(const NodeView& view, const QVariantMap& kept, QWidget* parent)
    : QWidget(parent)
    , m_camera(view.camera)
    , m_samples(named(new QSpinBox(this), "pictureSamples"))
    , m_hasLens(named(new QCheckBox(tr("&Depth of field"), this), "pictureLens"))
    , m_fStop(named(new QDoubleSpinBox(this), "pictureFStop"))
    , m_focus(named(new QDoubleSpinBox(this), "pictureFocus"))
    , m_pick(named(new QPushButton(tr("Pick the focus in the &view…"), this), "pictureFocusPick"))
{
    build();
    m_samples->setValue(kept.value(QStringLiteral("samples"), 1).toInt());
    m_hasLens->setChecked(kept.value(QStringLiteral("lens")).toBool());
    m_fStop->setValue(kept.value(QStringLiteral("fStop"), usualFStop).toDouble());
    if (view.lens.diameter > 0.0) { // as large for every f-stop of 1
        m_hasLens->setChecked(true);
        m_fStop->setValue(Lens::diameterOf(1.0, m_camera.fovRad) / view.lens.diameter);
        m_focus->setValue(view.lens.focus);
    }
    connect(m_hasLens, &QCheckBox::toggled, this, &LensForm::enable);
    connect(m_pick, &QPushButton::clicked, this, &LensForm::pickWanted);
    enable();
}

void LensForm::build()
{
    m_samples->setRange(1, mostSamples);
    m_samples->setToolTip(tr("Antialiasing samples of each pixel, 1 to 256: finer edges, and as many times "
                             "slower. Depth of field draws 32 or more"));
    m_hasLens->setToolTip(m_camera.orthographic
                              ? tr("A parallel view has no depth of field: everything is sharp")
                              : tr("Blurs what is nearer or farther than the focus, as the lens of a camera "
                                   "does. The picture takes 32 times as long"));
    m_fStop->setRange(0.1, 64.0);
    m_fStop->setDecimals(1);
    m_fStop->setSingleStep(0.1);
    m_fStop->setPrefix(tr("f/"));
    m_fStop->setToolTip(tr("Opening of the lens before a film of 24 mm, 0.1 to 64: the smaller the number, "
                           "the more is blurred"));
    m_focus->setRange(0.0, mostMetres);
    m_focus->setDecimals(2);
    m_focus->setSingleStep(0.1);
    m_focus->setSuffix(tr(" m"));
    m_focus->setSpecialValueText(
        tr("what the camera looks at (%1 m)").arg(QLocale().toString(m_camera.distance, 'f', 1)));
    m_focus->setToolTip(tr("Distance from the camera, in metres, at which everything is sharp; 0: what the "
                           "camera looks at"));
    m_pick->setToolTip(tr("Hides this dialog until you click what is to be sharp"));
    m_pick->setAutoDefault(false);
    auto* form = layoutOf<QFormLayout>(this);
    form->setHorizontalSpacing(14);
    form->setVerticalSpacing(8);
    addRow(form, tr("Samples &per pixel"), m_samples);
    form->addRow(m_hasLens);
    addRow(form, tr("F-&stop"), m_fStop);
    addRow(form, tr("&Focus"), m_focus);
    form->addRow(QString(), m_pick);
}

void LensForm::enable()
{
    m_hasLens->setEnabled(!m_camera.orthographic);
    for (QWidget* field :
         {static_cast<QWidget*>(m_fStop), static_cast<QWidget*>(m_focus), static_cast<QWidget*>(m_pick)})
        field->setEnabled(m_hasLens->isEnabled() && m_hasLens->isChecked());
}

int LensForm::samples() const
{
    return m_samples->value();
}

Lens LensForm::lens() const
{
    if (!m_hasLens->isEnabled() || !m_hasLens->isChecked())
        return {};
    return {Lens::diameterOf(m_fStop->value(), m_camera.fovRad), m_focus->value()};
}

void LensForm::setFocus(double metres)
{
    m_hasLens->setChecked(true);
    m_focus->setValue(std::max(metres, 0.01));
}

/// The focus is of this view, and so is not kept.
QVariantMap LensForm::settings() const
{
    return {{"samples", m_samples->value()}, {"lens", m_hasLens->isChecked()}, {"fStop", m_fStop->value()}};
}

} // namespace ramure
