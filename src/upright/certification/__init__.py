"""May this controller drive this robot? The certificate and what it tries."""

from upright.certification.certificate import Certificate as Certificate
from upright.certification.certificate import certify as certify
from upright.certification.certificate import read_certificate as read_certificate
