#include "widgets/view/light_dialog.h"

#include "widgets/base/named.h"
#include "widgets/view/render/light/picture_sky.h"
#include "widgets/view/render/light/sky.h"
#include "widgets/view/view_settings.h"
#include <QComboBox>
#include <QDateTimeEdit>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr int sliderSteps = 10; ///< of a slider, a unit of a field with decimals

void setUp(QDoubleSpinBox* box, QSlider* slider, double least, double most)
{
    box->setRange(least, most);
    box->setDecimals(1);
    box->setSingleStep(0.1);
    slider->setRange(int(least * sliderSteps), int(most * sliderSteps));
    slider->setPageStep(sliderSteps);
    QObject::connect(slider, &QSlider::valueChanged, box,
                     [box](int value) { box->setValue(double(value) / sliderSteps); });
    QObject::connect(box, &QDoubleSpinBox::valueChanged, slider,
                     [slider](double value) { slider->setValue(int(std::lround(value * sliderSteps))); });
}

void setUp(QSpinBox* box, QSlider* slider, int pageStep)
{
    slider->setRange(box->minimum(), box->maximum());
    slider->setPageStep(pageStep);
    QObject::connect(slider, &QSlider::valueChanged, box, &QSpinBox::setValue);
    QObject::connect(box, &QSpinBox::valueChanged, slider, &QSlider::setValue);
}

/// The label names its field, also to who cannot see it.
void addRow(QFormLayout* form, const QString& text, QWidget* field, QLayout* row = nullptr)
{
    auto* label = new QLabel(text, form->parentWidget());
    label->setBuddy(field);
    field->setAccessibleName(QString(text).remove(u'&'));
    if (row)
        form->addRow(label, row);
    else
        form->addRow(label, field);
}

void addRow(QFormLayout* form, const QString& text, QSlider* slider, QWidget* box, const QString& tip)
{
    slider->setMinimumWidth(220);
    box->setMinimumWidth(100);
    auto* row = new QHBoxLayout;
    row->setSpacing(10);
    row->addWidget(slider, 1);
    row->addWidget(box);
    addRow(form, text, box, row);
    slider->setAccessibleName(box->accessibleName());
    slider->setToolTip(tip);
    box->setToolTip(tip);
}

QFormLayout* spaced(QFormLayout* form)
{
    form->setHorizontalSpacing(14);
    form->setVerticalSpacing(10);
    return form;
}

} // namespace

LightDialog::LightDialog(ViewSettings* settings, QWidget* parent)
    : QDialog(parent)
    , m_settings(settings)
    , m_backdrop(named(new QComboBox(this), "backdrop"))
    , m_picture(named(new QLabel(this), "skyPicture"))
    , m_choosePicture(named(new QPushButton(tr("&Choose…"), this), "chooseSkyPicture"))
    , m_turnSlider(new QSlider(Qt::Horizontal, this))
    , m_turn(named(new QSpinBox(this), "pictureTurn"))
    , m_directionSlider(new QSlider(Qt::Horizontal, this))
    , m_direction(named(new QSpinBox(this), "sunDirection"))
    , m_heightSlider(new QSlider(Qt::Horizontal, this))
    , m_height(named(new QSpinBox(this), "sunHeight"))
    , m_hazeSlider(new QSlider(Qt::Horizontal, this))
    , m_haze(named(new QDoubleSpinBox(this), "haze"))
    , m_exposureSlider(new QSlider(Qt::Horizontal, this))
    , m_exposure(named(new QDoubleSpinBox(this), "exposure"))
    , m_whiteSlider(new QSlider(Qt::Horizontal, this))
    , m_white(named(new QSpinBox(this), "whiteBalance"))
    , m_moment(new QGroupBox(tr("The sun of a day and a place"), this))
    , m_time(named(new QDateTimeEdit(QDateTime(QDate::currentDate(), QTime(15, 0)), this), "sunTime"))
    , m_latitude(named(new QDoubleSpinBox(this), "latitude"))
    , m_longitude(named(new QDoubleSpinBox(this), "longitude"))
    , m_momentText(named(new QLabel(this), "momentText"))
{
    setObjectName(QStringLiteral("lightDialog"));
    m_backdrop->addItems(
        {tr("Landscape"), tr("Natural sky"), tr("Light studio"), tr("Dark studio"), tr("Sky picture")});
    m_backdrop->setToolTip(tr("Background of the trees: sky and meadow, the physical sky and light of a "
                              "clear day for the sun's height, one colour that takes shadows, or an own "
                              "picture all around that gives the light and the sun"));
    for (QSpinBox* box : {m_direction, m_turn}) {
        box->setRange(0, 359);
        box->setWrapping(true);
        box->setSuffix(tr("°"));
    }
    m_height->setRange(int(SceneLight::leastHeightDeg), 90);
    m_height->setSuffix(tr("°"));
    m_exposure->setSuffix(tr(" stops"));
    m_white->setRange(int(leastKelvin), int(mostKelvin));
    m_white->setSingleStep(100);
    m_white->setSuffix(tr(" K"));
    build();
    tellMoment();
    take();
    connect(m_backdrop, &QComboBox::currentIndexChanged, this, &LightDialog::apply);
    for (QSpinBox* box : {m_direction, m_height, m_turn, m_white})
        connect(box, &QSpinBox::valueChanged, this, &LightDialog::apply);
    for (QDoubleSpinBox* box : {m_haze, m_exposure})
        connect(box, &QDoubleSpinBox::valueChanged, this, &LightDialog::apply);
    connect(m_time, &QDateTimeEdit::dateTimeChanged, this, &LightDialog::tellMoment);
    for (QDoubleSpinBox* box : {m_latitude, m_longitude})
        connect(box, &QDoubleSpinBox::valueChanged, this, &LightDialog::tellMoment);
    settings->light.follow(this, [this] { take(); });
}

void LightDialog::build()
{
    setWindowTitle(tr("Light and backdrop"));
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(14);
    auto* form = spaced(new QFormLayout);
    layout->addLayout(form);
    addRow(form, tr("&Backdrop"), m_backdrop);
    buildPicture(form);
    setUp(m_direction, m_directionSlider, 15);
    setUp(m_height, m_heightSlider, 5);
    setUp(m_haze, m_hazeSlider, Sky::leastTurbidity, Sky::mostTurbidity);
    setUp(m_exposure, m_exposureSlider, -SceneLight::mostStops, SceneLight::mostStops);
    setUp(m_white, m_whiteSlider, 500);
    addRow(form, tr("Sun &from"), m_directionSlider, m_direction,
           tr("Direction of the sun, in degrees clockwise from the north (−Z): 90 is the east (X)"));
    addRow(form, tr("Sun &height"), m_heightSlider, m_height,
           tr("Height of the sun over the horizon, 2 to 90 degrees: a low one is warm"));
    addRow(form, tr("Ha&ze"), m_hazeSlider, m_haze,
           tr("Dust and water in the air of the natural sky: 2 is very clear, 8 hazy"));
    addRow(form, tr("E&xposure"), m_exposureSlider, m_exposure,
           tr("Brighter or darker by so many f-stops: 1 is twice the light"));
    addRow(
        form, tr("&White balance"), m_whiteSlider, m_white,
        tr("The light that the picture shows as white, in kelvin, as a camera has it: 6500 changes nothing, "
           "less makes the picture bluer, more makes it warmer"));
    buildMoment();
    layout->addWidget(m_moment);
    buildButtons();
}

void LightDialog::buildPicture(QFormLayout* form)
{
    m_choosePicture->setAutoDefault(false);
    m_choosePicture->setToolTip(tr("A linear picture all around (HDR or EXR), twice as wide as high, whose "
                                   "brightest spot is the sun"));
    auto* row = new QHBoxLayout;
    row->setSpacing(10);
    row->addWidget(m_picture, 1);
    row->addWidget(m_choosePicture);
    addRow(form, tr("Pict&ure"), m_choosePicture, row);
    setUp(m_turn, m_turnSlider, 15);
    addRow(form, tr("&Turned by"), m_turnSlider, m_turn,
           tr("Turns the picture and its sun around the vertical, in degrees clockwise seen from above"));
    connect(m_choosePicture, &QPushButton::clicked, this, &LightDialog::pictureWanted);
}

void LightDialog::buildMoment()
{
    m_time->setCalendarPopup(true);
    m_latitude->setRange(-90.0, 90.0);
    m_longitude->setRange(-180.0, 180.0);
    m_latitude->setValue(48.9);
    m_longitude->setValue(2.3);
    for (QDoubleSpinBox* box : {m_latitude, m_longitude})
        box->setDecimals(2);
    m_latitude->setSuffix(tr("°"));
    m_longitude->setSuffix(tr("°"));
    m_time->setToolTip(tr("Day and time, in this computer's time zone"));
    m_latitude->setToolTip(tr("Degrees north of the equator; south of it negative"));
    m_longitude->setToolTip(tr("Degrees east of Greenwich; west of it negative"));
    auto* form = spaced(new QFormLayout(m_moment));
    addRow(form, tr("&Day and time"), m_time);
    addRow(form, tr("&Latitude"), m_latitude);
    addRow(form, tr("L&ongitude"), m_longitude);
    m_takeMoment = named(new QPushButton(tr("&Put the sun there"), this), "takeMoment");
    m_takeMoment->setAutoDefault(false);
    m_momentText->setWordWrap(true);
    form->addRow(m_momentText);
    form->addRow(m_takeMoment);
    connect(m_takeMoment, &QPushButton::clicked, this, &LightDialog::takeMoment);
}

void LightDialog::buildButtons()
{
    auto* buttons = new QDialogButtonBox(this);
    m_usual = buttons->addButton(tr("Usual light"), QDialogButtonBox::ResetRole);
    buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole)->setDefault(true);
    m_usual->setAutoDefault(false);
    m_usual->setObjectName(QStringLiteral("usualLight"));
    layout()->addWidget(buttons);
    connect(m_usual, &QPushButton::clicked, this, [this] { m_settings->light.set({}); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void LightDialog::take()
{
    const SceneLight light = m_settings->light();
    m_taking = true;
    m_backdrop->setCurrentIndex(int(light.backdrop));
    m_direction->setValue(int(std::lround(light.azimuthDeg)) % 360);
    m_height->setValue(int(std::lround(light.heightDeg)));
    m_haze->setValue(light.turbidity);
    m_turn->setValue(int(std::lround(light.turnDeg)));
    const QString file = light.picture ? QString::fromStdString(light.picture->file) : QString();
    m_picture->setText(file.isEmpty() ? tr("none")
                                      : fontMetrics().elidedText(QFileInfo(file).fileName(), Qt::ElideMiddle,
                                                                 m_turnSlider->minimumWidth()));
    m_picture->setToolTip(file);
    m_exposure->setValue(light.exposure);
    m_white->setValue(int(std::lround(light.whiteKelvin)));
    m_taking = false;
    const bool isPicture = light.backdrop == Backdrop::Picture;
    for (QWidget* field :
         std::initializer_list<QWidget*>{m_direction, m_directionSlider, m_height, m_heightSlider, m_moment})
        field->setEnabled(!isPicture);
    m_turn->setEnabled(isPicture);
    m_turnSlider->setEnabled(isPicture);
    m_haze->setEnabled(light.backdrop == Backdrop::Sky);
    m_hazeSlider->setEnabled(light.backdrop == Backdrop::Sky);
    m_usual->setEnabled(light != SceneLight());
}

void LightDialog::apply()
{
    if (m_taking)
        return;
    SceneLight light = m_settings->light();
    const auto backdrop = static_cast<Backdrop>(m_backdrop->currentIndex());
    if (backdrop == Backdrop::Picture && !light.picture) {
        take(); // until there is one
        return emit pictureWanted();
    }
    light.azimuthDeg = m_direction->value();
    light.heightDeg = m_height->value();
    light.backdrop = backdrop;
    light.turbidity = m_haze->value();
    light.exposure = m_exposure->value();
    light.whiteKelvin = m_white->value();
    light.turnDeg = m_turn->value();
    m_settings->light.set(light);
}

SunPosition LightDialog::momentsSun() const
{
    return sunPosition(double(m_time->dateTime().toSecsSinceEpoch()), m_latitude->value(),
                       m_longitude->value());
}

void LightDialog::tellMoment()
{
    const SunPosition sun = momentsSun();
    const bool isUp = sun.heightDeg >= SceneLight::leastHeightDeg;
    m_takeMoment->setEnabled(isUp);
    m_momentText->setText(isUp ? tr("Then the sun stands at %1°, %2° high.")
                                     .arg(sun.azimuthDeg, 0, 'f', 0)
                                     .arg(sun.heightDeg, 0, 'f', 0)
                               : tr("Then the sun is below the horizon, or less than %1° above it.")
                                     .arg(SceneLight::leastHeightDeg));
}

void LightDialog::takeMoment()
{
    const SunPosition sun = momentsSun();
    SceneLight light = m_settings->light();
    light.azimuthDeg = sun.azimuthDeg;
    light.heightDeg = std::max(sun.heightDeg, SceneLight::leastHeightDeg);
    m_settings->light.set(light);
}

} // namespace ramure
