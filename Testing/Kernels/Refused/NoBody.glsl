float twice(float x) // Refused: function twice has no body
const float Half = 0.5;
