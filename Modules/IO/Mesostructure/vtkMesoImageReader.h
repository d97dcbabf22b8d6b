#ifndef vtkMesoImageReader_h
#define vtkMesoImageReader_h

/**
 * @class vtkMesoImageReader
 * @brief Read an image in its file's precision, through OpenImageIO.
 *
 * Output port 0: vtkImageData of the image's width and height with one component a channel, in the
 * file's order (grey, grey and alpha, RGB, RGBA, ...; indexed colors are looked up). 8 bit gives
 * unsigned char, 16 bit unsigned short, half and float give float. Values are those of the file: no
 * color conversion, no multiplication by alpha. Row 0 is the image's last row, at the bottom, so
 * that row 0 lies at texture coordinate t = 0. Spacing 1, origin 0.
 *
 * Refused, with one vtkErrorMacro line "file: reason" and an empty output: files that are missing,
 * truncated, damaged or no images; more than 16384 pixels in either direction or 4 GiB, before
 * memory is taken; volumes; integers with a sign or of 32 bits; float values that are NaN or
 * infinite (their number and the first place are named). Of a file of several images the first is
 * read, with a vtkWarningMacro line.
 *
 * @sa MesoToHeights
 */

#include "mesoIOMesostructureModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <string> // for messages
#include <vector> // for messages

class MESOIOMESOSTRUCTURE_EXPORT vtkMesoImageReader : public vtkImageAlgorithm
{
public:
  static vtkMesoImageReader* New();
  vtkTypeMacro(vtkMesoImageReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file to read; its contents decide on the format.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /// Why the last update gave nothing; empty where it gave an image.
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }
  /// What was odd about the file last read, a line each, without the file's name.
  const std::vector<std::string>& GetNotes() const { return this->Notes; }
  /// The channels of the file last read, one a component.
  const std::vector<std::string>& GetChannelNames() const { return this->ChannelNames; }

protected:
  vtkMesoImageReader();
  ~vtkMesoImageReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoImageReader(const vtkMesoImageReader&) = delete;
  void operator=(const vtkMesoImageReader&) = delete;

  void Read(vtkImageData* output);
  void Refuse(const std::string& message);

  char* FileName = nullptr;
  std::string ErrorMessage;
  std::vector<std::string> Notes;
  std::vector<std::string> ChannelNames;
};

#endif
