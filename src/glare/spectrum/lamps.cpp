#include "glare/spectrum/lamps.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "glare/base/embedded_file.h"
#include "glare/base/error.h"
#include "glare/spectrum/spectrum_table.h"

namespace glare {

extern const EmbeddedFile lamp_files[];
extern const std::size_t lamp_files_count;

namespace {

struct LampFile {
  const char* name;
  const char* alias;
  const char* description;
  const char* file_name;
};

// CIE 015:2018, tables 5 to 12; colour temperatures are those that the CIE gives.
constexpr LampFile kLamps[] = {
    {"A", "halogen", "incandescent light, 2856 K; stands for a halogen headlamp", "cie_a.csv"},
    {"B", "", "direct sunlight (obsolete)", "cie_b.csv"},
    {"C", "", "average daylight (obsolete)", "cie_c.csv"},
    {"D50", "", "daylight, 5003 K", "cie_d50.csv"},
    {"D55", "", "daylight, 5503 K", "cie_d55.csv"},
    {"D60", "", "daylight, 6000 K", "cie_d60.csv"},
    {"D65", "", "daylight, 6504 K", "cie_d65.csv"},
    {"D75", "", "daylight, 7504 K", "cie_d75.csv"},
    {"E", "", "equal energy at every wavelength", "cie_e.csv"},
    {"ID50", "", "indoor daylight, 5098 K", "cie_id50.csv"},
    {"ID65", "", "indoor daylight, 6603 K", "cie_id65.csv"},
    {"FL1", "", "fluorescent, standard, daylight 6430 K", "cie_fl1.csv"},
    {"FL2", "", "fluorescent, standard, cool white 4230 K", "cie_fl2.csv"},
    {"FL3", "", "fluorescent, standard, white 3450 K", "cie_fl3.csv"},
    {"FL4", "", "fluorescent, standard, warm white 2940 K", "cie_fl4.csv"},
    {"FL5", "", "fluorescent, standard, daylight 6350 K", "cie_fl5.csv"},
    {"FL6", "", "fluorescent, standard, light white 4150 K", "cie_fl6.csv"},
    {"FL7", "", "fluorescent, broad-band, 6500 K", "cie_fl7.csv"},
    {"FL8", "", "fluorescent, broad-band, 5000 K", "cie_fl8.csv"},
    {"FL9", "", "fluorescent, broad-band, 4150 K", "cie_fl9.csv"},
    {"FL10", "", "fluorescent, three narrow bands, 5000 K", "cie_fl10.csv"},
    {"FL11", "", "fluorescent, three narrow bands, 4000 K", "cie_fl11.csv"},
    {"FL12", "", "fluorescent, three narrow bands, 3000 K", "cie_fl12.csv"},
    {"FL3.1", "", "fluorescent, new set 3.1", "cie_fl3_1.csv"},
    {"FL3.2", "", "fluorescent, new set 3.2", "cie_fl3_2.csv"},
    {"FL3.3", "", "fluorescent, new set 3.3", "cie_fl3_3.csv"},
    {"FL3.4", "", "fluorescent, new set 3.4", "cie_fl3_4.csv"},
    {"FL3.5", "", "fluorescent, new set 3.5", "cie_fl3_5.csv"},
    {"FL3.6", "", "fluorescent, new set 3.6", "cie_fl3_6.csv"},
    {"FL3.7", "", "fluorescent, new set 3.7", "cie_fl3_7.csv"},
    {"FL3.8", "", "fluorescent, new set 3.8", "cie_fl3_8.csv"},
    {"FL3.9", "", "fluorescent, new set 3.9", "cie_fl3_9.csv"},
    {"FL3.10", "", "fluorescent, new set 3.10", "cie_fl3_10.csv"},
    {"FL3.11", "", "fluorescent, new set 3.11", "cie_fl3_11.csv"},
    {"FL3.12", "", "fluorescent, new set 3.12", "cie_fl3_12.csv"},
    {"FL3.13", "", "fluorescent, new set 3.13", "cie_fl3_13.csv"},
    {"FL3.14", "", "fluorescent, new set 3.14", "cie_fl3_14.csv"},
    {"FL3.15", "", "fluorescent, new set 3.15", "cie_fl3_15.csv"},
    {"HP1", "", "high-pressure sodium, standard, 1959 K", "cie_hp1.csv"},
    {"HP2", "", "high-pressure sodium, colour-enhanced, 2506 K", "cie_hp2.csv"},
    {"HP3", "", "high-pressure metal halide, 3144 K", "cie_hp3.csv"},
    {"HP4", "", "high-pressure metal halide, 4002 K", "cie_hp4.csv"},
    {"HP5", "hid", "high-pressure metal halide, 4039 K; stands for a HID (xenon) headlamp",
     "cie_hp5.csv"},
    {"LED-B1", "", "LED, blue with phosphor, 2733 K", "cie_led_b1.csv"},
    {"LED-B2", "", "LED, blue with phosphor, 2998 K", "cie_led_b2.csv"},
    {"LED-B3", "", "LED, blue with phosphor, 4103 K", "cie_led_b3.csv"},
    {"LED-B4", "led", "LED, blue with phosphor, 5109 K; stands for a LED headlamp",
     "cie_led_b4.csv"},
    {"LED-B5", "", "LED, blue with phosphor, 6598 K", "cie_led_b5.csv"},
    {"LED-BH1", "", "LED, blue with phosphor and red, 2851 K", "cie_led_bh1.csv"},
    {"LED-RGB1", "", "LED, red, green and blue, 2840 K", "cie_led_rgb1.csv"},
    {"LED-V1", "", "LED, violet with phosphors, 2724 K", "cie_led_v1.csv"},
    {"LED-V2", "", "LED, violet with phosphors, 4070 K", "cie_led_v2.csv"},
};

std::string folded(std::string_view name) {
  std::string result(name);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == '_') c = '-';
  }
  return result;
}

Spectrum read_lamp(const LampFile& lamp) {
  for (std::size_t i = 0; i < lamp_files_count; ++i)
    if (lamp_files[i].name == lamp.file_name)
      return parse_lamp_table(lamp_files[i].text, lamp.file_name);
  throw InputError(lamp.file_name, "is not among the embedded files");
}

double temperature_from(std::string_view text) {
  if (text.ends_with('k')) text.remove_suffix(1);
  double temperature_k = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), temperature_k);
  if (error != std::errc{} || stop != text.data() + text.size())
    throw OptionError("'blackbody:" + std::string(text) +
                      "': expected a temperature in kelvin, as in blackbody:3200");
  return temperature_k;
}

}  // namespace

std::vector<BuiltInLamp> built_in_lamps() {
  std::vector<BuiltInLamp> lamps;
  for (const LampFile& lamp : kLamps) lamps.push_back({lamp.name, lamp.alias, lamp.description});
  return lamps;
}

std::optional<Spectrum> find_lamp(std::string_view name) {
  constexpr std::string_view kBlackbody = "blackbody:";
  const std::string wanted = folded(name);
  if (wanted.starts_with(kBlackbody))
    return blackbody(temperature_from(std::string_view(wanted).substr(kBlackbody.size())));
  const auto* const lamp = std::find_if(std::begin(kLamps), std::end(kLamps), [&](const auto& l) {
    return !wanted.empty() && (folded(l.name) == wanted || l.alias == wanted);
  });
  if (lamp == std::end(kLamps)) return std::nullopt;
  return read_lamp(*lamp);
}

Spectrum blackbody(double temperature_k) {
  if (!(temperature_k >= 500 && temperature_k <= 100000)) {
    char text[96];
    std::snprintf(text, sizeof text, "a black body of %g K is outside 500 to 100000 K",
                  temperature_k);
    throw OptionError(text);
  }
  constexpr double c2_nm_k = 1.4388e7;
  std::vector<double> wavelengths_nm, power;
  for (int nm = 300; nm <= 830; ++nm) {
    wavelengths_nm.push_back(nm);
    power.push_back(std::pow(nm / 560.0, -5) / std::expm1(c2_nm_k / (nm * temperature_k)));
  }
  const double largest = *std::max_element(power.begin(), power.end());
  for (double& p : power) p /= largest;
  return Spectrum(std::move(wavelengths_nm), std::move(power));
}

}  // namespace glare
