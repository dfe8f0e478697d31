// Everything in glare::io: pictures, lamp tables and colour spaces in, templates in OpenEXR out.
#pragma once

#include "glare/io/aperture_file.h"
#include "glare/io/atomic_file.h"
#include "glare/io/color_config.h"
#include "glare/io/eye_photo.h"
#include "glare/io/image_file.h"
#include "glare/io/lamp_file.h"
#include "glare/io/memory.h"
#include "glare/io/photometry_file.h"
#include "glare/io/picture_document.h"
#include "glare/io/picture_file.h"
#include "glare/io/sha256.h"
#include "glare/io/template_file.h"
#include "glare/io/transform_cache.h"
#include "glare/io/zernike_file.h"
