#include "app/cli/picture_options.h"

#include "core/qt/base/system_path.h"
#include "widgets/view/render/light/picture_sky.h"
#include "widgets/view/render/light/sky.h"
#include "widgets/view/render/light/sun_position.h"
#include <QDateTime>
#include <QFileInfo>
#include <algorithm>
#include <cmath>

namespace ramure::cli {
namespace {

struct Background
{
    std::string_view name;
    std::optional<Backdrop> backdrop; ///< nothing: a transparent one
};
constexpr Background backgrounds[] = {{"landscape", Backdrop::Landscape},
                                      {"sky", Backdrop::Sky},
                                      {"light", Backdrop::LightStudio},
                                      {"dark", Backdrop::DarkStudio},
                                      {"none", std::nullopt}};

/// So many numbers with commas between them. \param form what is expected, for the error
Expected<std::vector<double>> numbersOf(const CommandLine& line, const char* option, qsizetype least,
                                        qsizetype most, const char* form)
{
    const QStringList words = line.value(option).split(u',');
    std::vector<double> numbers;
    for (const QString& word : words) {
        bool isNumber = false;
        numbers.push_back(word.toDouble(&isNumber));
        if (!isNumber || !(std::abs(numbers.back()) <= 1e6)) {
            numbers.clear();
            break;
        }
    }
    const auto count = static_cast<qsizetype>(numbers.size());
    if (count < least || count > most)
        return fail(ErrorCode::Invalid, "--%1 \"%2\": %3 expected",
                    {option, line.value(option).toStdString(), form});
    return numbers;
}

Expected<Camera> cameraOf(const CommandLine& line)
{
    const char* form = "EX,EY,EZ,TX,TY,TZ[,ANGLE], metres and degrees, or the name of a camera";
    const auto numbers = numbersOf(line, "camera", 6, 7, form);
    RAMURE_TRY(numbers);
    const std::vector<double>& n = *numbers;
    const glm::dvec3 eye(n[0], n[1], n[2]), target(n[3], n[4], n[5]), away = eye - target;
    const double angle = n.size() > 6 ? n[6] : glm::degrees(Camera().fovRad);
    const double distance = glm::length(away);
    if (distance < 1e-3 || angle < 1.0 || angle > 150.0)
        return fail(
            ErrorCode::Invalid,
            "--camera \"%1\": the eye must be a millimetre or more from the target, the angle 1 to 150 "
            "degrees",
            {line.value("camera").toStdString()});
    Camera camera;
    camera.target = target;
    camera.distance = distance;
    camera.pitchRad = std::asin(std::clamp(away.y / distance, -1.0, 1.0));
    camera.yawRad = std::atan2(away.x, away.z);
    camera.fovRad = glm::radians(angle);
    return camera;
}

Expected<void> takeNumber(const CommandLine& line, const char* option, double least, double most, double& out)
{
    if (!line.has(option))
        return {};
    bool isNumber = false;
    const double number = line.value(option).toDouble(&isNumber);
    if (!isNumber || !(number >= least && number <= most))
        return fail(ErrorCode::Invalid, "--%1 \"%2\": a number from %3 to %4 expected",
                    {option, line.value(option).toStdString(), QString::number(least).toStdString(),
                     QString::number(most).toStdString()});
    out = number;
    return {};
}

Expected<void> takeSunAt(const CommandLine& line, SceneLight& light)
{
    const QString value = line.value("sun-at");
    const QStringList words = value.split(u',');
    bool isLatitude = false, isLongitude = false;
    const double latitude = words.value(1).toDouble(&isLatitude);
    const double longitude = words.value(2).toDouble(&isLongitude);
    QDateTime time = QDateTime::fromString(words.front(), Qt::ISODate);
    if (time.timeSpec() == Qt::LocalTime)
        time.setTimeSpec(Qt::UTC); // the same picture wherever it is drawn
    if (words.size() != 3 || !time.isValid() || !isLatitude || !isLongitude ||
        !(std::abs(latitude) <= 90.0) || !(std::abs(longitude) <= 180.0))
        return fail(ErrorCode::Invalid,
                    "--sun-at \"%1\": TIME,LATITUDE,LONGITUDE expected, as 2026-06-21T18:30+02:00,48.9,2.3",
                    {value.toStdString()});
    const SunPosition sun = sunPosition(double(time.toSecsSinceEpoch()), latitude, longitude);
    if (sun.heightDeg < SceneLight::leastHeightDeg)
        return fail(ErrorCode::Invalid,
                    "--sun-at \"%1\": the sun stands %2 degrees high then; 2 or more are needed",
                    {value.toStdString(), QString::number(sun.heightDeg, 'f', 1).toStdString()});
    light.azimuthDeg = sun.azimuthDeg;
    light.heightDeg = sun.heightDeg;
    return {};
}

Expected<SceneLight> lightOf(const CommandLine& line)
{
    SceneLight light;
    if (line.has("sun") && line.has("sun-at"))
        return fail(ErrorCode::Invalid, "--sun goes without --sun-at");
    if (line.has("sun")) {
        const auto sun = numbersOf(line, "sun", 2, 2, "DIRECTION,HEIGHT in degrees");
        RAMURE_TRY(sun);
        if ((*sun)[1] < SceneLight::leastHeightDeg || (*sun)[1] > 90.0)
            return fail(ErrorCode::Invalid, "--sun \"%1\": its height must be 2 to 90 degrees",
                        {line.value("sun").toStdString()});
        light.azimuthDeg = (*sun)[0];
        light.heightDeg = (*sun)[1];
    }
    if (line.has("sun-at"))
        RAMURE_TRY(takeSunAt(line, light));
    for (const auto& taken :
         {takeNumber(line, "haze", Sky::leastTurbidity, Sky::mostTurbidity, light.turbidity),
          takeNumber(line, "exposure", -SceneLight::mostStops, SceneLight::mostStops, light.exposure),
          takeNumber(line, "white-balance", leastKelvin, mostKelvin, light.whiteKelvin)})
        RAMURE_TRY(taken);
    return light;
}

/// A picture brings its sun and its air.
Expected<void> takePicture(const CommandLine& line, SceneLight& light)
{
    for (const char* other : {"background", "sun", "sun-at", "haze", "sky-picture"})
        if (line.has(other))
            return fail(ErrorCode::Invalid, "--background-picture goes without --%1", {other});
    auto read = readPictureSky(systemPath(line.value("background-picture")));
    RAMURE_TRY(read);
    light.picture = std::move(*read);
    light.backdrop = Backdrop::Picture;
    return takeNumber(line, "background-turn", -360.0, 360.0, light.turnDeg);
}

Expected<void> takeBackground(const CommandLine& line, RenderOptions& options)
{
    if (line.has("background-picture"))
        return takePicture(line, options.light);
    if (line.has("background-turn"))
        return fail(ErrorCode::Invalid, "--background-turn needs --background-picture");
    const std::string background = line.value("background").toStdString();
    const auto* known = std::ranges::find(backgrounds, background, &Background::name);
    if (known == std::end(backgrounds))
        return fail(ErrorCode::Unknown, "--background \"%1\": landscape, sky, light, dark or none expected",
                    {background});
    options.world = known->backdrop.has_value();
    options.light.backdrop = known->backdrop.value_or(Backdrop::Landscape);
    return {};
}

void addSkyOptions(CommandLine& line)
{
    line.add({QStringLiteral("sky-picture")},
             QStringLiteral("Also writes the sky of --background sky, all around and without the sun, as a "
                            "picture for other renderers."),
             QStringLiteral("FILE.hdr"));
    line.add({QStringLiteral("sky-sun")}, QStringLiteral("The sun is in the picture of --sky-picture too."));
    line.add({QStringLiteral("background-picture")},
             QStringLiteral("An own sky, instead of --background: a linear picture all around, twice as wide "
                            "as high. It gives the light, and its brightest spot the sun with its shadows."),
             QStringLiteral("FILE.hdr|FILE.exr"));
    line.add({QStringLiteral("background-turn")},
             QStringLiteral("Turns --background-picture around the vertical: degrees clockwise seen from "
                            "above, -360 to 360. Without it the middle of the picture is in the east (X)."),
             QStringLiteral("DEGREES"));
}

} // namespace

void addPictureOptions(CommandLine& line)
{
    line.add({QStringLiteral("camera")},
             QStringLiteral(
                 "Where the camera stands and what it looks at, in metres, and its vertical angle "
                 "in degrees (40 without it); or the name of a camera of the scene, which moves as its keys "
                 "say. Without this option all that is visible is shown."),
             QStringLiteral("EX,EY,EZ,TX,TY,TZ[,ANGLE]"));
    line.add({QStringLiteral("sun")},
             QStringLiteral("Where the sun stands: degrees clockwise from the north (-Z; 90 is the east, X), "
                            "and its height over the horizon, 2 to 90; 136,46 without it."),
             QStringLiteral("DIRECTION,HEIGHT"));
    line.add({QStringLiteral("sun-at")},
             QStringLiteral("The sun of a moment and a place instead: as 2026-06-21T18:30+02:00,48.9,2.3 "
                            "(latitude north, longitude east; without +02:00 it is UTC)."),
             QStringLiteral("TIME,LATITUDE,LONGITUDE"));
    line.add({QStringLiteral("haze")},
             QStringLiteral("Of the air of --background sky: 2 (very clear) to 8 (hazy); 3 without it."),
             QStringLiteral("N"));
    line.add({QStringLiteral("white-balance")},
             QStringLiteral("The light that the picture shows as white, in kelvin, 3000 (bluer pictures) to "
                            "12000 (warmer ones); 6500 without it."),
             QStringLiteral("KELVIN"));
    line.add({QStringLiteral("exposure")}, QStringLiteral("Brighter or darker by so many f-stops, -5 to 5."),
             QStringLiteral("STOPS"));
    line.add(
        {QStringLiteral("f-stop")},
        QStringLiteral("Depth of field: what is not as far away as --focus is blurred, as by a lens before "
                       "a film of 24 mm, 0.1 to 64; the smaller, the more. Draws 32 pictures in one."),
        QStringLiteral("N"));
    line.add(
        {QStringLiteral("focus")},
        QStringLiteral("What is sharp, with --f-stop: metres from the camera. Without it, what the camera "
                       "looks at."),
        QStringLiteral("METRES"));
    line.addDefault(
        {QStringLiteral("samples")},
        QStringLiteral(
            "Antialiasing samples of each pixel, 1 to 256: finer edges, and as many times slower."),
        QStringLiteral("N"), QStringLiteral("1"));
    addSkyOptions(line);
    line.add({QStringLiteral("figure")},
             QStringLiteral("A person of 1.8 m stands beside the first tree, to show how large it is."));
    line.add({QStringLiteral("bare-ground")},
             QStringLiteral("Neither grass nor fallen leaves lie around the feet of trees."));
    line.addDefault(
        {QStringLiteral("quality")},
        QStringLiteral("draft (sun and sky light alone), good (crowns that are darker inside, the "
                       "response of film; the usual) or best (several samples a pixel, shadows "
                       "of whole leaves; slower)."),
        QStringLiteral("draft|good|best"), QStringLiteral("good"));
    line.addDefault(
        {QStringLiteral("background")},
        QStringLiteral("landscape (sky and meadow), sky (a clear day as it is: light and colours by "
                       "where the sun stands), light or dark (a studio of one colour that takes "
                       "shadows) or none (transparent)."),
        QStringLiteral("landscape|sky|light|dark|none"), QStringLiteral("landscape"));
}

Expected<PictureOptions> pictureOptionsOf(const CommandLine& line)
{
    PictureOptions out;
    const auto light = lightOf(line);
    RAMURE_TRY(light);
    out.options.light = *light;
    double samples = 1.0;
    for (const auto& taken :
         {takeNumber(line, "f-stop", 0.1, 64.0, out.fStop), takeNumber(line, "focus", 0.001, 1e6, out.focus),
          takeNumber(line, "samples", 1.0, 256.0, samples)})
        RAMURE_TRY(taken);
    if (line.has("focus") && !line.has("f-stop"))
        return fail(ErrorCode::Invalid, "--focus needs --f-stop");
    out.options.pictures = int(std::lround(samples));
    const QString quality = line.value("quality");
    const auto row = std::ranges::find(qualities(), quality.toStdString(), &ModeRow<Quality>::name);
    if (row == qualities().end())
        return fail(ErrorCode::Unknown, "--quality \"%1\": draft, good or best expected",
                    {quality.toStdString()});
    out.options.quality = row->mode;
    RAMURE_TRY(takeBackground(line, out.options));
    out.skyHasSun = line.has("sky-sun");
    if (out.skyHasSun && !line.has("sky-picture"))
        return fail(ErrorCode::Invalid, "--sky-sun needs --sky-picture");
    out.skyFile = line.value("sky-picture");
    if (!out.skyFile.isEmpty() && QFileInfo(out.skyFile).suffix().toLower() != QLatin1String("hdr"))
        return fail(ErrorCode::Unknown, "%1: unknown file ending: the sky is written as .hdr",
                    {out.skyFile.toStdString()});
    const QString seenFrom = line.value("camera");
    if (!seenFrom.isEmpty() && !seenFrom.contains(u',')) {
        out.cameraNode = seenFrom;
    } else if (line.has("camera")) {
        const auto camera = cameraOf(line);
        RAMURE_TRY(camera);
        out.camera = *camera;
    }
    return out;
}

RenderOptions optionsFor(const PictureOptions& picture, const NodeView& view)
{
    RenderOptions options = picture.options;
    options.lens = view.lens;
    if (picture.fStop > 0.0)
        options.lens = {Lens::diameterOf(picture.fStop, view.camera.fovRad), picture.focus};
    return options;
}

} // namespace ramure::cli
