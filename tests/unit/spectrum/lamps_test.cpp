#include "glare/spectrum/lamps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "glare/base/error.h"
#include "glare/color/color_space.h"
#include "glare/io/sha256.h"
#include "glare/spectrum/observer.h"

namespace glare {
namespace {

const std::string kFolder = GLARE_SOURCE_DIR "/data/lamps/";

/// Of the files as the CIE's tables were published, held here and not beside them.
const std::map<std::string, std::string> kSha256 = {
    {"cie_a.csv", "76ac739f628c6fe7b8884d0e146e26a219b08b51fd0e3b26f22a7a9fa000fbec"},
    {"cie_b.csv", "e8354e633dcbad67e5f58bd55786c78703de7190852d67045b9b615a7a909b6e"},
    {"cie_c.csv", "90d3f6213028c4a9f6d01e643d40119a811612c84de2dadaf82ad600cb43d99d"},
    {"cie_d50.csv", "ab4e09a15a015fad811b6e5a34bf0e76d41aede267d1216d20522334e28ceca4"},
    {"cie_d55.csv", "4fe06340c2af0eff5c4d3439374b9414c5d868c6e75c09cbb7683a91e5a2529e"},
    {"cie_d60.csv", "e910277cc838c1dceff98a791363a0616858ce8b38596bf09238e97eafa4b25e"},
    {"cie_d65.csv", "41c5bf23f0f3b8e11db9db1b7bddb4f4f2816c1b68d78b14729fb7e5f047521c"},
    {"cie_d75.csv", "50cb065da3b8571796613635585f2919a0d5b39a667ad82d83abf6244c3166c1"},
    {"cie_e.csv", "7dfc5727580df3fbad925fabcdab04cf8a5f56451a141b30108cf07dd5d9dc47"},
    {"cie_fl1.csv", "eef2c696d03b5aae78ac03bd3f6b41c09ae228c43095fad5bb94c85962e80697"},
    {"cie_fl10.csv", "091c53229d0746c69c6f4e542b7fa272347e3ac424540067e082ce40049127da"},
    {"cie_fl11.csv", "b82167351e950261a116ecc24a8fbc177df1106e9fe0003c5c3b4ed78f528325"},
    {"cie_fl12.csv", "579eba7bcfb75dd9e1295116ef7417dc7ae10343ba3373528f25a9b4fa23431b"},
    {"cie_fl2.csv", "2f9d3e2300f04b1e5c5fdb9496741701e8fad70feee96f0667382a4d7b1c7963"},
    {"cie_fl3.csv", "b6bf461b7981f2c6d862cfb9d88826f9e325e057e2e95fb67fa4fa99977ca3fd"},
    {"cie_fl3_1.csv", "2a9eb582d1636d4c83952583dbd53b5d9fc77baa1ff624c86f76b642065c9fa6"},
    {"cie_fl3_10.csv", "dc2577c345ba52c608ce218d088a278d2fb9403ac7899f5ce0edd1d53f0bc6b9"},
    {"cie_fl3_11.csv", "b233d94f869abf292f9b0d6f66527c3c21abaa5a91630ffb17ce29329e2f81aa"},
    {"cie_fl3_12.csv", "0c646ba45fc3dadc4ed68131e5333ad545fce6b06161962db3d2632286fc063a"},
    {"cie_fl3_13.csv", "a2c36d9d387cf62137840c3e7c6ebe50f4ba42da845f5890107d12b1198bde48"},
    {"cie_fl3_14.csv", "230011150a9e9a86912bd97f1700dcd04de74c8e03b57fc1603fa6f4f696ce77"},
    {"cie_fl3_15.csv", "6c54461f18ba59d489c72e581b701962559b575d71cc0736d9c6a7db19047575"},
    {"cie_fl3_2.csv", "47e5ba4a2e6b6002d8c03de82d0f0a302ca67396f529a622cdfadbcd2cf48be2"},
    {"cie_fl3_3.csv", "474b040abd12ea2cea86b700b357eedc20dc48cd6fd48c677326fa88e0078e2a"},
    {"cie_fl3_4.csv", "ccac866c1fd3d8aa045252675cc973ceddef7294ca7cf49e6eff48c587cad1a5"},
    {"cie_fl3_5.csv", "300c290f4ce5c49a0cb3600bd3bc1fa099308afe82405e4372700897542c01c5"},
    {"cie_fl3_6.csv", "a675294ba36bae5664aa2b872230029a92edf4667aa40f0c74e1bd54b9f5673a"},
    {"cie_fl3_7.csv", "9340b1f62d1fdcee54087b56e1f3bd5cfe355d5bf3364cb664295496a9c392db"},
    {"cie_fl3_8.csv", "8706a6404ec576e26241008fc9313b44a0c018e70eeab75314a6f29c72e942b5"},
    {"cie_fl3_9.csv", "313e7332513cc6d941e4067b8914a2c8de5680dbb03e3998af734e4a7eef7a46"},
    {"cie_fl4.csv", "44441de0e8cddac04a3c96dd664716007ffb1625947ee3ead2f411d807a4e823"},
    {"cie_fl5.csv", "d3335e4c8973505be53a41ac6c504b5152b9bc268575d6357525fcbcf39820ab"},
    {"cie_fl6.csv", "9275538dce9be0c26e9809bd16bffdd30af37a9b5ea377c3149e099005d62cdd"},
    {"cie_fl7.csv", "e7011d6982e9107b7fc8aac81344cd845b4285ef024441adf1e4f3ee4c227ddd"},
    {"cie_fl8.csv", "7d01c00ba01effb8c5d3b5ff8fae88ee887cfbcddd31db73372e885548239de2"},
    {"cie_fl9.csv", "e453c2825225ea6b96122adc2e94942f44aff35ba8d6a11b228138e161f56f3f"},
    {"cie_hp1.csv", "0caf0009304f8773c87cf881104721a1078581e292638b35851a17c0f2fbef78"},
    {"cie_hp2.csv", "3cd5fcdc6902c833f7611df11c63845207c4cf06ed8a17ebfa36e2a7002de1fd"},
    {"cie_hp3.csv", "e3fca83bc2c9ab565f4d41cd215c01a6baa10cf5c25cd3d0b25f2dcfbe3e84c4"},
    {"cie_hp4.csv", "8830d552af641ecef3cb43a15ad05401c82c95ec1cae4a8f263de77736b151d7"},
    {"cie_hp5.csv", "ee3c9da451a6374f3b91b4e922b82b139e89c1e762339a5df2f288da3749b490"},
    {"cie_id50.csv", "4e94ec180ffb9f298a3c0b860385e03da5a3bd8098fcb3af408c545f85199468"},
    {"cie_id65.csv", "b3d8a2ab22275d5fe48c04834baa4814b3120d2ccd4b478f780c348dc660aec8"},
    {"cie_led_b1.csv", "ec9bea0ecbe6c402cef66fc3f740d6353881528b3a09c3edf588e45dc9df9dd0"},
    {"cie_led_b2.csv", "bcfc7252edd16c2d5835a285733833903235ee9a42252d39c1551e8d0b435b20"},
    {"cie_led_b3.csv", "2af244d78b7f96a10df85d29bb600608003b22c786656c95215eedb5a5f9f4c6"},
    {"cie_led_b4.csv", "aa664432842488a1769c46de10206cffa46388dff9cfb8f19533428b2d6e7778"},
    {"cie_led_b5.csv", "42ad9a0f6a7d17dcdc0bf2409b362c8d64724d936bcbcbe38beda9c05e538d23"},
    {"cie_led_bh1.csv", "6970b16036b08432162b4b1806a778981996db15cf6b801dedb9043d23766058"},
    {"cie_led_rgb1.csv", "26efe698835d672eec033f9e27945af6f80da83146672b0b7c4012b5d7a1e653"},
    {"cie_led_v1.csv", "5d6babe2ad29fa64af7043edc31093d6f17bb633398f0f14423d39d0e6e49b59"},
    {"cie_led_v2.csv", "d54526b09625a80fa385fe35539783875870340ad6b30106b0c5cafb1f4715dd"},
};

std::string file_of(std::string lamp) {
  for (char& c : lamp) c = c == '-' || c == '.' ? '_' : static_cast<char>(std::tolower(c));
  return "cie_" + lamp + ".csv";
}

Chromaticity chromaticity_of(const Spectrum& lamp) {
  return chromaticity(
      xyz_from_spectrum(lamp, color_matching_functions("cie1931-2deg"), {360, 830}));
}

TEST(Lamps, TheTablesAreThePublishedOnes) {
  for (const auto& [file, sha256] : kSha256) EXPECT_EQ(sha256_of_file(kFolder + file), sha256);
}

TEST(Lamps, EveryRowIsTheTables) {
  EXPECT_EQ(built_in_lamps().size(), kSha256.size());
  for (const BuiltInLamp& lamp : built_in_lamps()) {
    ASSERT_TRUE(kSha256.contains(file_of(lamp.name))) << lamp.name;
    const auto spectrum = find_lamp(lamp.name);
    ASSERT_TRUE(spectrum.has_value()) << lamp.name;
    EXPECT_FALSE(lamp.description.empty());
    std::ifstream file(kFolder + file_of(lamp.name));
    std::string header;
    std::getline(file, header);
    std::size_t rows = 0;
    char comma;
    for (double nm, power; file >> nm >> comma >> power; ++rows)
      ASSERT_EQ((*spectrum)(nm), power) << lamp.name << ", " << nm;
    EXPECT_EQ(rows, spectrum->values().size()) << lamp.name;
    EXPECT_GE(rows, 81u) << lamp.name;
  }
}

struct Published {
  const char* lamp;
  double x, y;
};

TEST(Lamps, ChromaticitiesAreTheCies) {
  constexpr double kTolerance = 3e-4;  // Four digits, and tables of 5 nm that are interpolated.
  constexpr std::array<Published, 18> kPublished = {{{"A", .44758, .40745},
                                                     {"D65", .31270, .32900},
                                                     {"D50", .34570, .35850},
                                                     {"C", .31006, .31616},
                                                     {"FL2", .3721, .3751},
                                                     {"FL7", .3129, .3292},
                                                     {"FL11", .3805, .3769},
                                                     {"HP1", .5330, .4150},
                                                     {"HP2", .4778, .4158},
                                                     {"HP3", .4302, .4075},
                                                     {"HP4", .3812, .3797},
                                                     {"HP5", .3776, .3713},
                                                     {"LED-B1", .4560, .4078},
                                                     {"LED-B3", .3756, .3723},
                                                     {"LED-B5", .3118, .3236},
                                                     {"LED-BH1", .4474, .4066},
                                                     {"LED-RGB1", .4557, .4211},
                                                     {"LED-V1", .4548, .4044}}};
  for (const Published& p : kPublished) {
    const Chromaticity found = chromaticity_of(*find_lamp(p.lamp));
    EXPECT_NEAR(found.x, p.x, kTolerance) << p.lamp;
    EXPECT_NEAR(found.y, p.y, kTolerance) << p.lamp;
  }
}

TEST(Lamps, NamesInAnySpellingAndAliases) {
  const auto same = [](const char* a, const char* b) {
    return std::ranges::equal(find_lamp(a)->values(), find_lamp(b)->values());
  };
  EXPECT_TRUE(same("led-b3", "LED-B3"));
  EXPECT_TRUE(same("Led_B3", "LED-B3"));
  EXPECT_TRUE(same("fl3.12", "FL3.12"));
  EXPECT_TRUE(same("halogen", "A"));
  EXPECT_TRUE(same("HID", "HP5"));
  EXPECT_TRUE(same("led", "LED-B4"));
  for (const char* name : {"", "D", "D651", " A", "FL13", "blackbody", "candle"})
    EXPECT_FALSE(find_lamp(name).has_value()) << name;
}

double planck(double nm, double temperature_k) {
  return std::pow(nm, -5) / std::expm1(1.4388e7 / (nm * temperature_k));
}

TEST(Blackbody, FollowsPlancksLaw) {
  for (const double t : {500.0, 2856.0, 6504.0, 100000.0}) {
    const Spectrum s = blackbody(t);
    EXPECT_EQ(s.range(), (WavelengthRange{300, 830}));
    EXPECT_EQ(*std::ranges::max_element(s.values()), 1);
    EXPECT_NEAR(s(450) / s(650) / (planck(450, t) / planck(650, t)), 1, 1e-12) << t;
    EXPECT_NEAR(s(300) / s(830) / (planck(300, t) / planck(830, t)), 1, 1e-12) << t;
  }
}

TEST(Blackbody, FollowsWiensDisplacementLaw) {
  constexpr double kWien_nm_k = 1.4388e7 / 4.965114231744276;  // x = 5 (1 - exp(-x))
  for (const double t : {3600.0, 5000.0, 6504.0, 9000.0}) {
    const Spectrum s = blackbody(t);
    const auto brightest = std::ranges::max_element(s.values()) - s.values().begin();
    EXPECT_NEAR(s.wavelengths_nm()[brightest], kWien_nm_k / t, 0.51) << t;  // Samples of 1 nm.
  }
}

TEST(Blackbody, StandsForIlluminantAAt2856K) {
  // The CIE defines A by Planck's law with c2 = 1.435e-2 m K at 2848 K: 2855.5 K by today's c2.
  const Chromaticity a = chromaticity_of(*find_lamp("blackbody:2856"));
  EXPECT_NEAR(a.x, .44758, 2e-4);
  EXPECT_NEAR(a.y, .40745, 2e-4);
}

TEST(Blackbody, ByName) {
  for (const char* name :
       {"blackbody:3200", "BlackBody:3200", "blackbody:3.2e3", "blackbody:3200K"})
    EXPECT_TRUE(std::ranges::equal(find_lamp(name)->values(), blackbody(3200).values())) << name;
  for (const char* name : {"blackbody:", "blackbody:hot", "blackbody:3200 K", "blackbody:499",
                           "blackbody:100001", "blackbody:-3200", "blackbody:nan", "blackbody:inf"})
    EXPECT_THROW(find_lamp(name), OptionError) << name;
}

}  // namespace
}  // namespace glare
