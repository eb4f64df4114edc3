#include "widgets/view/light_dialog.h"

#include "widgets/view/view_settings.h"
#include <QComboBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>
#include <cmath>

namespace ramure {

LightDialog::LightDialog(ViewSettings* settings, QWidget* parent)
    : QDialog(parent)
    , m_settings(settings)
    , m_backdrop(new QComboBox(this))
    , m_directionSlider(new QSlider(Qt::Horizontal, this))
    , m_direction(new QSpinBox(this))
    , m_heightSlider(new QSlider(Qt::Horizontal, this))
    , m_height(new QSpinBox(this))
{
    setObjectName(QStringLiteral("lightDialog"));
    m_backdrop->setObjectName(QStringLiteral("backdrop"));
    m_direction->setObjectName(QStringLiteral("sunDirection"));
    m_height->setObjectName(QStringLiteral("sunHeight"));
    for (int i = 0; i < backdropCount; ++i)
        m_backdrop->addItem(QString());
    m_direction->setRange(0, 359);
    m_direction->setWrapping(true);
    m_height->setRange(int(SceneLight::leastHeightDeg), 90);
    m_directionSlider->setPageStep(15);
    m_heightSlider->setPageStep(5);
    build();
    retranslate();
    connect(m_backdrop, &QComboBox::currentIndexChanged, this, &LightDialog::apply);
    for (QSpinBox* box : {m_direction, m_height})
        connect(box, &QSpinBox::valueChanged, this, &LightDialog::apply);
    connect(settings, &ViewSettings::lightChanged, this, &LightDialog::take);
}

void LightDialog::build()
{
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(14);
    m_form = new QFormLayout;
    m_form->setHorizontalSpacing(14);
    m_form->setVerticalSpacing(10);
    m_form->addRow(new QLabel(this), m_backdrop);
    const std::pair<QSlider*, QSpinBox*> rows[] = {{m_directionSlider, m_direction},
                                                   {m_heightSlider, m_height}};
    for (const auto& [slider, box] : rows) {
        slider->setRange(box->minimum(), box->maximum());
        slider->setMinimumWidth(220);
        auto* row = new QHBoxLayout;
        row->setSpacing(10);
        row->addWidget(slider, 1);
        row->addWidget(box);
        m_form->addRow(new QLabel(this), row);
        connect(slider, &QSlider::valueChanged, box, &QSpinBox::setValue);
        connect(box, &QSpinBox::valueChanged, slider, &QSlider::setValue);
    }
    layout->addLayout(m_form);
    auto* buttons = new QDialogButtonBox(this);
    m_usual = buttons->addButton(QString(), QDialogButtonBox::ResetRole);
    m_close = buttons->addButton(QString(), QDialogButtonBox::RejectRole);
    m_close->setDefault(true);
    m_usual->setAutoDefault(false);
    layout->addWidget(buttons);
    connect(m_usual, &QPushButton::clicked, this, [this] { m_settings->setLight({}); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void LightDialog::take()
{
    const SceneLight light = m_settings->light();
    m_taking = true;
    m_backdrop->setCurrentIndex(int(light.backdrop));
    m_direction->setValue(int(std::lround(light.azimuthDeg)) % 360);
    m_height->setValue(int(std::lround(light.heightDeg)));
    m_taking = false;
    m_usual->setEnabled(light != SceneLight());
}

void LightDialog::apply()
{
    if (!m_taking)
        m_settings->setLight({double(m_direction->value()), double(m_height->value()),
                              static_cast<Backdrop>(m_backdrop->currentIndex())});
}

void LightDialog::retranslate()
{
    setWindowTitle(tr("Light and backdrop"));
    m_backdrop->setItemText(int(Backdrop::Landscape), tr("Landscape"));
    m_backdrop->setItemText(int(Backdrop::LightStudio), tr("Light studio"));
    m_backdrop->setItemText(int(Backdrop::DarkStudio), tr("Dark studio"));
    m_backdrop->setToolTip(
        tr("What lies behind and below the trees: sky and meadow, or one colour that takes "
           "their shadow"));
    const QString direction =
        tr("Where the sun stands, in degrees clockwise from the north (−Z): 90 is the east (X)");
    const QString height = tr("Height of the sun over the horizon, 2 to 90 degrees: a low one is warm");
    m_direction->setToolTip(direction);
    m_directionSlider->setToolTip(direction);
    m_height->setToolTip(height);
    m_heightSlider->setToolTip(height);
    m_direction->setSuffix(tr("°"));
    m_height->setSuffix(tr("°"));
    const QString labels[] = {tr("&Backdrop"), tr("Sun &from"), tr("Sun &height")};
    QWidget* const fields[] = {m_backdrop, m_direction, m_height};
    for (int row = 0; row < 3; ++row) {
        auto* label = qobject_cast<QLabel*>(m_form->itemAt(row, QFormLayout::LabelRole)->widget());
        label->setText(labels[row]);
        label->setBuddy(fields[row]);
        fields[row]->setAccessibleName(QString(labels[row]).remove(u'&'));
    }
    m_directionSlider->setAccessibleName(m_direction->accessibleName());
    m_heightSlider->setAccessibleName(m_height->accessibleName());
    m_usual->setText(tr("Usual light"));
    m_close->setText(tr("Close"));
    take();
}

void LightDialog::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

} // namespace ramure
